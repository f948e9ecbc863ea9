// A channel that is read at another time and with another gain: taps by hand, sums on polynomials, limits.
#include "firmware/conditioning/channel_shift.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using firmware::ChannelShift;
using firmware::Scaled;
using firmware::shift_taps;
using firmware::ShiftTaps;

constexpr double kOne = 1 << 30;

void expect_taps(const ShiftTaps& taps, int first, const std::vector<double>& expected) {
  EXPECT_EQ(taps.first, first);
  for (int i = 0; i < firmware::kShiftTaps; ++i) EXPECT_NEAR(taps.tap[i].raw / kOne, expected[i], 2 / kOne) << i;
}

// Lagrange's basis at nodes -2 to 3. At 1/2: (3, -25, 150, 150, -25, 3) / 256. At a node it is that node alone.
TEST(ChannelShift, TapsAreThoseOfThePolynomialThroughSixSamples) {
  const Scaled one = Scaled::from_int(1);
  expect_taps(shift_taps(Scaled::ratio(1, 2), one), -2,
              {3 / 256.0, -25 / 256.0, 150 / 256.0, 150 / 256.0, -25 / 256.0, 3 / 256.0});
  expect_taps(shift_taps(Scaled::ratio(-5, 2), one), -5,
              {3 / 256.0, -25 / 256.0, 150 / 256.0, 150 / 256.0, -25 / 256.0, 3 / 256.0});
  expect_taps(shift_taps(Scaled{}, one), -2, {0, 0, 1, 0, 0, 0});
  expect_taps(shift_taps(Scaled::from_int(-3), one), -5, {0, 0, 1, 0, 0, 0});
  expect_taps(shift_taps(Scaled::from_int(3), one), 0, {0, 0, 0, 1, 0, 0});  // the end of the last interval
  expect_taps(shift_taps(Scaled{}, Scaled::ratio(5, 4)), -2, {0, 0, 0.8, 0, 0, 0});
}

// Channel 0 is t^3 - 40 t^2 (late by 3/2), channel 1 is 1000 t. A polynomial of degree 5 and less is read exactly: at
// t = 20 the newest sample is 25, and what is read stands at 21.5: 21.5^3 - 40 21.5^2 = 9938.375 - 18490 = -8551.6.
TEST(ChannelShift, AShiftedChannelIsReadBetweenItsSamplesAndTheOthersWait) {
  ChannelShift shift;
  EXPECT_FALSE(shift.used());
  shift.set(0, 0, shift_taps(Scaled::ratio(3, 2), Scaled::from_int(1)));
  shift.restart();
  EXPECT_TRUE(shift.used());
  for (int t = 0; t <= 25; ++t) {
    int32_t code[2] = {t * t * t - 40 * t * t, 1000 * t};
    bool at_limit = false;
    const bool usable = shift.shift(
        2, [&](int c) -> int32_t& { return code[c]; }, at_limit);
    EXPECT_EQ(usable, t >= firmware::kShiftHistory - 1) << t;
    EXPECT_FALSE(at_limit);
    if (!usable) continue;
    EXPECT_EQ(code[1], 1000 * (t - firmware::kShiftReach));
    const double at = t - firmware::kShiftReach + 1.5;
    EXPECT_NEAR(code[0], at * at * at - 40 * at * at, 0.51) << t;
    if (t == 25) {
      EXPECT_EQ(code[0], -8552);
    }
  }
}

// Full scale one way, then the other: between them the polynomial overshoots.
TEST(ChannelShift, WhatLeaves24BitsIsCutOffAndToldSo) {
  ChannelShift shift;
  shift.set(0, 0, shift_taps(Scaled::ratio(1, 2), Scaled::ratio(4, 5)));
  shift.restart();
  int limits = 0;
  for (int t = 0; t < 40; ++t) {
    int32_t code = (t / 6) % 2 == 0 ? (1 << 23) - 1 : -(1 << 23) + 1;
    bool at_limit = false;
    shift.shift(
        1, [&](int) -> int32_t& { return code; }, at_limit);
    EXPECT_LE(std::abs(code), 1 << 23);
    limits += at_limit;
    if (at_limit) {
      EXPECT_EQ(std::abs(code), 1 << 23);
    }
  }
  EXPECT_GT(limits, 20);  // a gain of 0.8: 1.25 of full scale nearly everywhere
}

// A cosine of ten samples a period, late by 0.4 of one: 3e-4 of it is what the polynomial lacks, of a million 300.
TEST(ChannelShift, TenSamplesAPeriodAreReadToThreeInTenThousand) {
  ChannelShift shift;
  shift.set(0, 0, shift_taps(Scaled::ratio(2, 5), Scaled::from_int(1)));
  shift.restart();
  double worst = 0;
  for (int t = 0; t < 200; ++t) {
    int32_t code = static_cast<int32_t>(std::lround(1e6 * std::cos(0.2 * M_PI * (t - 0.4))));
    bool at_limit = false;
    if (!shift.shift(
            1, [&](int) -> int32_t& { return code; }, at_limit))
      continue;
    worst = std::max(worst, std::fabs(code - 1e6 * std::cos(0.2 * M_PI * (t - firmware::kShiftReach))));
  }
  EXPECT_LT(worst, 320);
  EXPECT_GT(worst, 50);  // and not by having read nothing
}

}  // namespace
