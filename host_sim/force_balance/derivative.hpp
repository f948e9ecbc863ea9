// Derivatives of sampled signals by a local quadratic over 9 samples (least squares; the fit's slope or curvature at
// the middle sample). The first and last 4 samples have none: the result is 8 samples shorter.
#pragma once
#include <cstddef>
#include <vector>

namespace host_sim {

constexpr size_t kDerivativeMargin = 4;

std::vector<double> first_derivative(const std::vector<double>& values, double period_s);
std::vector<double> second_derivative(const std::vector<double>& values, double period_s);
// The same samples without change: to stand beside a derivative.
std::vector<double> without_margins(const std::vector<double>& values);

}  // namespace host_sim
