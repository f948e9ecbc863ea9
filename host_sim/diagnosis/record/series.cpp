#include "series.hpp"

#include <algorithm>
#include <cmath>

namespace diagnosis {

double rms_about_mean(const Series& y) { return std::sqrt((y.array() - y.mean()).square().mean()); }

namespace {

// Places of n samples about their middle.
Series about_middle(Eigen::Index n) {
  const double half = 0.5 * static_cast<double>(n - 1);
  return Series::LinSpaced(n, -half, half);
}

}  // namespace

double slope_of_line(const Series& y) {
  const Series at = about_middle(y.size());
  return y.size() > 1 ? at.dot(y) / at.squaredNorm() : 0;
}

double square_off_line(const Series& y) {
  const Series line = slope_of_line(y) * about_middle(y.size());
  return y.size() == 0 ? 0 : (y.array() - y.mean() - line.array()).square().sum();
}

bool travels(const Series& y) {
  if (y.size() < 2) return false;
  const double n = static_cast<double>(y.size());
  return std::abs(slope_of_line(y)) * (n - 1) > kTravels * std::sqrt(square_off_line(y) / n);
}

Series integral(const Series& y, double period_s) {
  const Eigen::Index n = y.size();
  const auto at = [&](Eigen::Index i) { return y[std::clamp<Eigen::Index>(i, 0, n - 1)]; };
  Series sum(n);
  sum[0] = 0;
  for (Eigen::Index i = 1; i < n; ++i)
    sum[i] = sum[i - 1] + period_s / 24 * (13 * (at(i - 1) + y[i]) - at(i - 2) - at(i + 1));
  return sum;
}

}  // namespace diagnosis
