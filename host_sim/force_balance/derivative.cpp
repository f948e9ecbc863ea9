#include "host_sim/force_balance/derivative.hpp"

namespace host_sim {
namespace {

constexpr int kHalf = static_cast<int>(kDerivativeMargin);

template <typename Weight>
std::vector<double> convolved(const std::vector<double>& values, double scale, Weight weight) {
  std::vector<double> result;
  if (values.size() <= 2 * kDerivativeMargin) return result;
  result.reserve(values.size() - 2 * kDerivativeMargin);
  for (size_t middle = kDerivativeMargin; middle + kDerivativeMargin < values.size(); ++middle) {
    double sum = 0.0;
    for (int k = -kHalf; k <= kHalf; ++k)
      sum += weight(k) * values[middle + static_cast<size_t>(k + kHalf) - kDerivativeMargin];
    result.push_back(scale * sum);
  }
  return result;
}

}  // namespace

// Slope of a least-squares parabola: sum k y_k / sum k^2, sum k^2 = 2 (1 + 4 + 9 + 16) = 60.
std::vector<double> first_derivative(const std::vector<double>& values, double period_s) {
  return convolved(values, 1.0 / (60.0 * period_s), [](int k) { return static_cast<double>(k); });
}

// Curvature: 2 sum (k^2 - 60 / 9) y_k / sum (k^2 - 60 / 9)^2; the last sum is 708 - 60^2 / 9 = 308.
std::vector<double> second_derivative(const std::vector<double>& values, double period_s) {
  return convolved(values, 2.0 / (308.0 * period_s * period_s),
                   [](int k) { return static_cast<double>(k * k) - 60.0 / 9.0; });
}

std::vector<double> without_margins(const std::vector<double>& values) {
  if (values.size() <= 2 * kDerivativeMargin) return {};
  return {values.begin() + static_cast<std::ptrdiff_t>(kDerivativeMargin),
          values.end() - static_cast<std::ptrdiff_t>(kDerivativeMargin)};
}

}  // namespace host_sim
