// Sums over lines, against the sums themselves.
#include "host_sim/plant/instruments/line_sum.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using Complex = std::complex<double>;
constexpr double kPi = 3.14159265358979323846;

// Two lines of amplitude 1 and i at 90 and 180 degrees a step, n = 0 .. 3, worked out by hand:
// i^n + i (-1)^n = 1 + i, i - i, -1 + i, -i - i.
TEST(LineSum, TwoLinesByHand) {
  const auto sum = host_sim::LineSum(2, 4, 0.25, 0.25).of({1.0, Complex(0, 1)});
  const Complex expected[] = {{1, 1}, {0, 0}, {-1, 1}, {0, -2}};
  ASSERT_EQ(sum.size(), 4u);
  for (size_t n = 0; n < 4; ++n) EXPECT_LT(std::abs(sum[n] - expected[n]), 1e-15);
}

TEST(LineSum, OneLineAndOneTime) {
  EXPECT_LT(std::abs(host_sim::LineSum(1, 1, 0.3, 0.0).of({2.0})[0] - 2.0), 1e-15);
  EXPECT_LT(std::abs(host_sim::LineSum(1, 3, 0.3, 0.0).of({2.0})[2] - std::polar(2.0, 1.2 * kPi)), 4e-15);
}

// As many lines and knots as 40 s of a band of 45 Hz at 1 kHz have, and more lines than knots; amplitudes of 1 and any phase. The sum
// of squares is the number of lines, so 1e-13 of its root is a thousand roundings.
TEST(LineSum, ManyLines) {
  for (const auto& [lines, count] : {std::pair<size_t, size_t>{1887, 41940}, {300, 7}}) {
    const double first = 5.0e-3, spacing = 45.0e-3 / static_cast<double>(lines);
    std::vector<Complex> amplitude(lines);
    for (size_t k = 0; k < lines; ++k)
      amplitude[k] = std::polar(1.0, 2 * kPi * std::fmod(0.618 * static_cast<double>(k * k), 1.0));
    const auto sum = host_sim::LineSum(lines, count, first, spacing).of(amplitude);
    for (const size_t n : {size_t{0}, size_t{1}, count / 3, count - 1}) {
      std::complex<long double> direct = 0;
      for (size_t k = 0; k < lines; ++k) {
        const long double angle = 2 * std::acos(-1.0L) * (first + static_cast<long double>(spacing) * k) * n;
        direct += std::complex<long double>(amplitude[k]) * std::polar<long double>(1.0L, angle);
      }
      EXPECT_LT(std::abs(sum[n] - Complex(direct)), 1e-13 * std::sqrt(static_cast<double>(lines))) << n;
    }
  }
}

}  // namespace
