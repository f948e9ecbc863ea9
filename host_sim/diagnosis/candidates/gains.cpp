// Gains from sums of products alone: no column is run again.
#include "gains.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace diagnosis::runs {
namespace {

constexpr double kDistinct = 1e-5;      // share of a column's square that the model cannot make itself
constexpr double kTwoDistinct = 1e-8;   // of the product of two columns' squares: they are not one
constexpr double kMostLeverage = 0.95;  // of a block: a value that hangs on it alone is not infinitely unsure

Mat inverse_of(const Mat& gram) {
  const Index p = gram.rows();
  if (p == 0) return gram;
  const Vec scale = gram.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  Mat a = scale.asDiagonal() * gram * scale.asDiagonal();
  a.diagonal().array() += 1e-10;
  return scale.asDiagonal() * a.ldlt().solve(Mat::Identity(p, p)) * scale.asDiagonal();
}

}  // namespace

Gains::Gains(const BlockSums& sums) : sums_(sums) {
  const Index p = sums.parameters();
  Mat gram = Mat::Zero(p, p);
  with_parameters_ = Mat::Zero(sums.columns(), p), score_ = Vec::Zero(p);
  for (size_t b = 0; b < sums.blocks(); ++b)
    gram += sums.gram[b], with_parameters_ += sums.with_parameters[b], score_ += sums.score[b];
  inverse_ = inverse_of(gram);
  by_model_ = with_parameters_ * inverse_;
}

double Gains::square_left(Index i) const {
  return sums_.square.row(i).sum() - by_model_.row(i).dot(with_parameters_.row(i));
}

double Gains::residual_left(Index i) const { return sums_.with_residual.row(i).sum() - by_model_.row(i).dot(score_); }

// From the influence of every block on the value, corrected for its leverage.
double Gains::deviate(Index i, double value, double left) const {
  const auto by_model = by_model_.row(i);
  double influence = 0, leverage = 0;
  for (size_t b = 0; b < sums_.blocks(); ++b) {
    const Index at = static_cast<Index>(b);
    const double own = sums_.square(i, at) - 2 * by_model.dot(sums_.with_parameters[b].row(i)) +
                       by_model * sums_.gram[b] * by_model.transpose();
    const double h = std::clamp(own / left, 0.0, kMostLeverage);
    const double s = (sums_.with_residual(i, at) - by_model.dot(sums_.score[b]) - value * own) / left / (1 - h);
    influence += s * s, leverage += h * h;
  }
  const double blocks = std::max(1.0, 1 / std::max(1e-12, leverage));
  return std::abs(normal_deviate(value / std::sqrt(influence + 1e-300), blocks));
}

Gain Gains::of_column(Index i) const {
  const double left = square_left(i);
  if (!(left > kDistinct * sums_.square.row(i).sum())) return {};
  const double right = residual_left(i), value = right / left;
  return {right * value / sums_.residual_square, deviate(i, value, left), {value}};
}

Gain Gains::of_two(Index i) const {
  Eigen::Matrix2d a;
  a(0, 0) = square_left(i), a(1, 1) = square_left(i + 1);
  a(0, 1) = a(1, 0) = sums_.with_next.row(i).sum() - by_model_.row(i).dot(with_parameters_.row(i + 1));
  if (!(a.determinant() > kTwoDistinct * a(0, 0) * a(1, 1))) return {};
  const Eigen::Vector2d right(residual_left(i), residual_left(i + 1)), value = a.inverse() * right;
  const double z = std::max(of_column(i).z, of_column(i + 1).z);
  return {value.dot(right) / sums_.residual_square, z, {value[0], value[1]}};
}

Vec Gains::moves(Index i, const std::vector<double>& value) const {
  Vec moves = Vec::Zero(score_.size());
  for (size_t k = 0; k < value.size(); ++k) moves -= value[k] * by_model_.row(i + static_cast<Index>(k)).transpose();
  return moves;
}

}  // namespace diagnosis::runs
