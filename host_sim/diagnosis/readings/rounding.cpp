#include "rounding.hpp"

#include <cmath>

namespace diagnosis::runs {
namespace {

using Vec = Eigen::VectorXd;
using Index = Eigen::Index;

constexpr double kReach = 3;  // standard deviations of the widest Gaussian: a thousandth is beyond

Vec gaussian(double variance, Index half) {
  Vec g(2 * half + 1);
  for (Index i = -half; i <= half; ++i) g[i + half] = std::exp(-0.5 * static_cast<double>(i * i) / variance);
  return g / g.sum();
}

}  // namespace

Rounding::Rounding(double samples) {
  if (!(samples > 0)) return;
  const double variance = samples * samples;
  const Index half = static_cast<Index>(std::ceil(kReach * std::sqrt(3 * variance)));
  // 1 - (1 - g)^3, and the powers of a Gaussian's response are wider Gaussians
  kernel_ = 3 * gaussian(variance, half) - 3 * gaussian(2 * variance, half) + gaussian(3 * variance, half);
}

Vec Rounding::of(const Eigen::Ref<const Vec>& y) const {
  Vec out = y;
  const Index half = kernel_.size() / 2;
  for (Index i = half; any() && i + half < y.size(); ++i) out[i] = kernel_.dot(y.segment(i - half, kernel_.size()));
  return out;
}

}  // namespace diagnosis::runs
