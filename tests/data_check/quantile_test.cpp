// Quantiles against a sorted copy.
#include "host_sim/data_check/measures/quantile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using host_sim::data_check::quantile;
using host_sim::data_check::quantiles;

TEST(Quantile, OfFewByHand) {
  // Sorted 1 2 3 5 8: four steps, so that 0.5 is the third value, 0.7 (2.8 steps) still the third and 0.75 the fourth.
  const std::vector<double> values{8, 1, 3, 2, 5};
  EXPECT_EQ(quantile(values, 0), 1);
  EXPECT_EQ(quantile(values, 0.5), 3);
  EXPECT_EQ(quantile(values, 0.7), 3);
  EXPECT_EQ(quantile(values, 0.75), 5);
  EXPECT_EQ(quantile(values, 1), 8);
  EXPECT_EQ(quantiles(values, 0.25, 1), std::make_pair(2.0, 8.0));
  EXPECT_EQ(quantile({}, 0.5), 0);
}

// Long columns of every kind that a sample could mislead: smooth, random, coarse, and one whose sampled places are all alike.
TEST(Quantile, OfManyAsSorted) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (const size_t count : {2048u, 4096u, 20129u, 65536u, 300000u})
    for (int kind = 0; kind < 5; ++kind) {
      std::vector<double> values(count);
      for (size_t i = 0; i < count; ++i) {
        const double noise = normal(random);
        values[i] = kind == 0   ? noise
                    : kind == 1 ? std::sin(0.01 * static_cast<double>(i))
                    : kind == 2 ? std::round(noise)
                    : kind == 3 ? (i % (count / 256) == 0 ? 100.0 : noise)
                                : static_cast<double>(count - i);
      }
      std::vector<double> sorted = values;
      std::sort(sorted.begin(), sorted.end());
      for (const double q : {0.0, 0.001, 0.05, 0.5, 0.77, 0.95, 0.999, 1.0})
        EXPECT_EQ(quantile(values, q), sorted[static_cast<size_t>(q * static_cast<double>(count - 1))])
            << count << " " << kind << " " << q;
    }
}

}  // namespace
