// What columns of candidates would bring beside the model, in closed form, with its numbers free to give way.
#pragma once
#include "block_sums.hpp"

namespace diagnosis::runs {

// Of one column, or of two that stand or fall together.
struct Gain {
  double share = 0;           // of the squared residual that it would take
  double z = 0;               // significance, as a normal deviate
  std::vector<double> value;  // coefficients; empty: the model can make these columns itself
};

class Gains {
 public:
  explicit Gains(const BlockSums& sums);
  Gain of_column(Index column) const;
  Gain of_two(Index column) const;  // with the next one
  // Of the model's numbers beside columns with these coefficients.
  Vec moves(Index column, const std::vector<double>& value) const;
  // Of all blocks: the model's inverse normal matrix and its score.
  const Mat& inverse() const { return inverse_; }
  const Vec& score() const { return score_; }

 private:
  double square_left(Index column) const;    // of what the model cannot make of it
  double residual_left(Index column) const;  // of that with the residual
  double deviate(Index column, double value, double left) const;
  const BlockSums& sums_;
  Mat with_parameters_, inverse_;
  Mat by_model_;  // columns x parameters: what of a column the model makes
  Vec score_;
};

}  // namespace diagnosis::runs
