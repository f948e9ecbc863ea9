// What a screening asks of columns: sums over rows of their products, as rows are still at hand.
#pragma once
#include "../simulate/simulator.hpp"

namespace diagnosis::runs {

struct ColumnSums {
  Vec square, with_next, with_residual;  // a number a column; with_next: with the next column
  Mat with_parameters;                   // columns x parameters
  Mat with_states;                       // columns x states, where a basis of what these make is given

  ColumnSums(Index columns, Index parameters, Index states);
  // Of a stretch of rows (they are columns of `made`, a row a column; basis: states x rows, or empty). `made` is weighted.
  void add(Mat& made, double weight, const Mat& basis, const Sensitivity& parameters, const Vec& residual, Index from,
           Index count);
  // Parameters and residual are free of what states can make; the columns become so.
  void take_out_states();
};

}  // namespace diagnosis::runs
