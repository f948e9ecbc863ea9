#include "tests/host_sim/estimate_fixture.hpp"

#include <cmath>

namespace estimate_test {

std::string free_decay(int samples, double late_s) {
  const double d = 1.5 / 4.0, w = std::sqrt(400.0 - d * d);
  const auto x = [&](double t) { return 0.01 * std::exp(-d * t) * std::cos(w * t); };
  const auto v = [&](double t) { return -0.01 * std::exp(-d * t) * (d * std::cos(w * t) + w * std::sin(w * t)); };
  std::string text = "t_s,displacement_1_m,velocity_1_m_s\n";
  for (int i = 0; i < samples; ++i) text += test_support::row({i * 1e-3, x(i * 1e-3 - late_s), v(i * 1e-3)});
  return text;
}

}  // namespace estimate_test
