#include "column_sums.hpp"

#include <algorithm>

#include "../fit/outer_sums.hpp"

namespace diagnosis::runs {
namespace {

constexpr Index kCached = 2048;  // numbers of `made` that are worked on at a time: the nearest cache holds them

}  // namespace

ColumnSums::ColumnSums(Index columns, Index parameters, Index states)
    : square(Vec::Zero(columns)),
      with_next(square),
      with_residual(square),
      with_parameters(Mat::Zero(columns, parameters)),
      with_states(Mat::Zero(columns, states)) {}

void ColumnSums::add(Mat& made, double weight, const Mat& basis, const Sensitivity& parameters, const Vec& residual,
                     Index from, Index count) {
  const Index columns = made.rows(), stretch = std::max<Index>(1, kCached / std::max<Index>(1, columns));
  for (Index at = from; at < from + count; at += stretch) {
    const Index rows = std::min(stretch, from + count - at);
    if (weight != 1) made.middleCols(at, rows) *= weight;
    const Rows own{made.data() + at * columns, columns, columns};
    add_row_sums(own, residual.data() + at, rows, square.data(), with_next.data(), with_residual.data());
    const Index p = parameters.cols(), s = with_states.cols();
    if (p > 0) add_outer_sums(own, {parameters.data() + at * p, p, p}, rows, with_parameters.data());
    if (s > 0) add_outer_sums(own, {basis.data() + at * s, s, s}, rows, with_states.data());
  }
}

void ColumnSums::take_out_states() {
  const Index n = square.size();
  square -= with_states.rowwise().squaredNorm();
  for (Index i = 0; i + 1 < n; ++i) with_next[i] -= with_states.row(i).dot(with_states.row(i + 1));
}

}  // namespace diagnosis::runs
