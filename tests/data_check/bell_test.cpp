// Bells made from narrower ones against the plain way.
#include "host_sim/data_check/measures/bell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using host_sim::data_check::bell;
using host_sim::data_check::twice_as_wide;

std::vector<double> noise(size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> values(count);
  for (double& value : values) value = normal(random);
  return values;
}

std::vector<double> every(const std::vector<double>& values, size_t h) {
  std::vector<double> thinned(values.size() / h);
  for (size_t i = 0; i < thinned.size(); ++i) thinned[i] = values[i * h];
  return thinned;
}

// A parabola's slope under a bell of any width is the parabola's slope at the bell's middle, 3 h samples on.
TEST(Bell, SlopeOfAParabola) {
  std::vector<double> y(200);
  for (size_t i = 0; i < y.size(); ++i) y[i] = 0.5 * static_cast<double>(i * i);
  const std::vector<double> slope = bell(y, 1, 4, 1.0);
  ASSERT_EQ(slope.size(), 176u);
  EXPECT_NEAR(slope[0], 12.0, 1e-9);
  EXPECT_NEAR(slope[100], 112.0, 1e-9);
}

TEST(Bell, AWiderOneFromANarrowerOne) {
  for (const size_t count : {97u, 1000u, 1037u}) {
    const std::vector<double> y = noise(count, static_cast<unsigned>(count));
    for (int k = 0; k <= 4; ++k) {
      const std::vector<double> made = twice_as_wide(every(bell(y, k, 2, 1e-3), 2));
      const std::vector<double> direct = every(bell(y, k, 4, 1e-3), 4);
      ASSERT_LE(made.size(), direct.size());
      EXPECT_GE(made.size() + 1, direct.size());
      double largest = 0.0;
      for (const double value : direct) largest = std::max(largest, std::abs(value));
      for (size_t i = 0; i < made.size(); ++i) EXPECT_NEAR(made[i], direct[i], 1e-10 * largest) << count << " " << k;
    }
  }
}

TEST(Bell, NothingFromTooFew) { EXPECT_TRUE(twice_as_wide(std::vector<double>(6, 1.0)).empty()); }

}  // namespace
