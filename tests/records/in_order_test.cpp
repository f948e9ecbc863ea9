// Sorted numbers against std::sort: spread, in steps, all in one place.
#include "host_sim/records/times/in_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

void expect_as_sorted(std::vector<double> values) {
  const std::vector<double> ours = host_sim::in_order(values);
  std::sort(values.begin(), values.end());
  EXPECT_EQ(ours, values);
}

template <typename Draw>
std::vector<double> drawn(size_t count, Draw draw) {
  std::vector<double> values(count);
  for (double& value : values) value = draw();
  return values;
}

TEST(InOrder, ByHand) {
  EXPECT_EQ(host_sim::in_order({}), std::vector<double>());
  EXPECT_EQ(host_sim::in_order({3.0, 0.0, 2.0}), (std::vector<double>{0.0, 2.0, 3.0}));
}

TEST(InOrder, WhateverTheSpread) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> even(0.0, 8.0);
  std::normal_distribution<double> normal(0.0, 1e-9);
  for (const size_t count : {2, 255, 256, 257, 20000}) {
    expect_as_sorted(drawn(count, [&] { return even(random); }));
    expect_as_sorted(drawn(count, [&] { return std::fabs(normal(random)); }));
    expect_as_sorted(drawn(count, [&] { return std::exp(10.0 * even(random)); }));         // nearly all in one drawer
    expect_as_sorted(drawn(count, [&] { return 0.001 * std::nearbyint(even(random)); }));  // a few values
    expect_as_sorted(drawn(count, [] { return 0.25; }));                                   // one
    expect_as_sorted(drawn(count, [&] { return even(random) > 7.99 ? 1e300 : std::fabs(normal(random)); }));
    expect_as_sorted(drawn(count, [&] { return even(random) < 4.0 ? 1e-308 : 1.5e308; }));  // the ends of all numbers
  }
}

TEST(InOrder, CrowdsAmongTheOthers) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> even(0.0, 1.0);
  std::vector<double> values = drawn(5000, [&] { return even(random); });
  for (size_t i = 0; i < 1500; ++i) values[3 * i] = 0.5 + 1e-9 * even(random);
  expect_as_sorted(values);
}

}  // namespace
