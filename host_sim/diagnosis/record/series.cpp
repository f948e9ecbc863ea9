#include "series.hpp"

#include <algorithm>
#include <cmath>

namespace diagnosis {

double rms_about_mean(const Series& y) { return std::sqrt((y.array() - y.mean()).square().mean()); }

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
