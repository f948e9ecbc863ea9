#include "firmware/fixed_point/functions.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace firmware;

TEST(Functions, SineOverTheWholeTurn) {
  double worst = 0.0;
  for (uint64_t turns = 0; turns < (uint64_t{1} << 32); turns += 999983) {
    const double got = std::ldexp(sine_of_turns(static_cast<uint32_t>(turns)).raw, -30);
    worst = std::fmax(worst, std::fabs(got - std::sin(2.0 * M_PI * std::ldexp(static_cast<double>(turns), -32))));
  }
  EXPECT_LT(worst, 2e-8);
}

TEST(Functions, SineAtItsCorners) {
  EXPECT_EQ(sine_of_turns(0).raw, 0);
  EXPECT_NEAR(sine_of_turns(0x40000000u).raw, 1 << 30, 20);  // quarter turn: 1
  EXPECT_NEAR(sine_of_turns(0xC0000000u).raw, -(1 << 30), 20);
  EXPECT_NEAR(sine_of_turns(0x80000000u).raw, 0, 20);
}

TEST(Functions, ExponentialFromOneDownToNothing) {
  double worst = 0.0;
  for (int64_t x = 0; x < (int64_t{33} << 26); x += 77777) {
    const double got = std::ldexp(exp2_of_minus(Fixed<int64_t, 26>::from_raw(x)).raw, -30);
    worst = std::fmax(worst, std::fabs(got - std::exp2(-std::ldexp(static_cast<double>(x), -26))));
  }
  EXPECT_LT(worst, 2e-8);
}
