// Where is the sign of a rate clear, and what does a sign look like behind a high-pass?
#include "firmware/links/clear_sign.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "firmware/links/high_passed_sign.hpp"

namespace {

using namespace firmware;

constexpr int kVelocity = signal_column(0, Quantity::kVelocity);

struct Signs {
  bool is_clear[kFrameStride] = {};
  int32_t own[kFrameStride] = {};
  int clear(int i) const { return is_clear[i] ? own[i] : 0; }
};

RateGains one_velocity() {
  RateGains gains;
  gains.has_a = true;
  gains.gain_a = RateGain::from_raw(1 << 23);
  gains.column_a = kVelocity;
  return gains;
}

Signs of(const Frame& frame, bool measured = true, Scaled noise = {}) {
  ClearSign sign;
  sign.configure(one_velocity(), measured, false, noise);
  Signs result;
  sign.fill(frame, 2, 37, 35, result.is_clear, Column<Code>(result.own));
  return result;
}

// A rate of 1000 with noise of +-10 in turn: the neighbours' rate is (4 * 2 (1000 -+ 10) - 2 (1000 +- 10)) / 6 = 1000 -+ 16.7,
// which differs from the sample's own by 26.7; four of them are 107, far below 1000.
TEST(ClearSign, IsClearFarAboveTheNoise) {
  const auto frame = std::make_unique<Frame>();
  for (int i = 0; i < kFrameStride; ++i) frame->raw[kVelocity][i] = -1000 + (i % 2 == 0 ? 10 : -10);
  const Signs signs = of(*frame);
  for (int i = 2; i < 37; ++i) EXPECT_EQ(signs.clear(i), -1);
}

// The same noise about a rate of 60, which is below 107.
TEST(ClearSign, IsNotClearWithinFourMeanDifferences) {
  const auto frame = std::make_unique<Frame>();
  for (int i = 0; i < kFrameStride; ++i) frame->raw[kVelocity][i] = 60 + (i % 2 == 0 ? 10 : -10);
  const Signs signs = of(*frame);
  for (int i = 2; i < 37; ++i) {
    EXPECT_EQ(signs.clear(i), 0);
    EXPECT_EQ(signs.own[i], 1);
  }
}

// A rate of 60 whose neighbours all agree, as those of noise that has passed a low-pass do. Its fading mean is 60 (1 - (63/64)^n) after
// n samples: 14.81 after 18 and 15.51 after 19. Beside noise of 5 the 19th is the first beyond 15; beside noise of 21 none is.
TEST(ClearSign, WhatIsLessThanThreeTimesItsKnownNoiseIsRest) {
  const auto frame = std::make_unique<Frame>();
  for (int i = 0; i < kFrameStride; ++i) frame->raw[kVelocity][i] = 60;
  const Signs moves = of(*frame, false, Scaled::from_int(5)), rests = of(*frame, false, Scaled::from_int(21));
  for (int i = 2; i < 37; ++i) {
    EXPECT_EQ(moves.clear(i), i >= 2 + 18 ? 1 : 0) << i;
    EXPECT_EQ(rests.clear(i), 0);
  }
}

// A link that slips with a rate of 600 and sticks for five samples, where noise of 10 that has passed a low-pass reads 20: neighbours
// agree, and the mean of the last 64 still knows the motion. Of a measured velocity that is rest, 20 < 30; of a derived one it is not.
TEST(ClearSign, AMeasuredVelocityThatSticksForLessThanTheMeanIsRest) {
  const auto slips = std::make_unique<Frame>(), sticks = std::make_unique<Frame>();
  for (int i = 0; i < kFrameStride; ++i)
    slips->raw[kVelocity][i] = 600, sticks->raw[kVelocity][i] = i < 20 || i > 24 ? 600 : 20;
  for (const bool measured : {true, false}) {
    ClearSign sign;
    sign.configure(one_velocity(), measured, false, Scaled::from_int(10));
    Signs signs;
    for (int block = 0; block < 60; ++block) sign.fill(*slips, 2, 37, 35, signs.is_clear, Column<Code>(signs.own));
    for (int i = 2; i < 37; ++i) EXPECT_EQ(signs.clear(i), 1);
    sign.fill(*sticks, 2, 37, 35, signs.is_clear, Column<Code>(signs.own));
    EXPECT_EQ(signs.clear(22), measured ? 0 : 1);
    for (int i = 2; i < 18; ++i) EXPECT_EQ(signs.clear(i), 1);
  }
}

TEST(ClearSign, ALinkAtRestIsNeverClear) {
  const auto frame = std::make_unique<Frame>();
  const Signs signs = of(*frame);
  for (int i = 2; i < 37; ++i) EXPECT_EQ(signs.clear(i), 0);
}

// On a straight line the neighbours foretell every sample; where it crosses zero at a sample no sign is clear.
TEST(ClearSign, OnAStraightLineEverySampleButTheCrossingIsClear) {
  const auto frame = std::make_unique<Frame>();
  for (int i = 0; i < kFrameStride; ++i) frame->raw[kVelocity][i] = 100 * (i - 20);
  const Signs signs = of(*frame);
  for (int i = 2; i < 37; ++i) EXPECT_EQ(signs.clear(i), (i > 20) - (i < 20));
}

// One section with the pole 1 - 1/4 on a step from 0 to 1: 1, 3/4, 9/16, ... times 2^20.
TEST(HighPassedSign, AStepDecaysWithTheFiltersPole) {
  HighPassedSign filter;
  int32_t sign[kFrameStride] = {0, 1 << 20, 1 << 20, 1 << 20, 1 << 20};
  filter.fill(1, 2, 0, 5, 5, Column<PassedSign>(sign));
  const int32_t expected[] = {0, 1 << 20, 3 << 18, 9 << 16, 27 << 14};
  for (int i = 0; i < 5; ++i) EXPECT_EQ(sign[i], expected[i]);
}

// Behind a low-pass, half a step: 0, 1/2, 3/8, 9/32, ...; read and written in one column.
TEST(HighPassedSign, TakesWhatHasPassedALowPass) {
  HighPassedSign filter;
  int32_t sign[kFrameStride] = {0, 1 << 19, 1 << 19, 1 << 19};
  filter.fill(1, 2, 0, 4, 4, Column<PassedSign>(sign));
  const int32_t expected[] = {0, 1 << 19, 3 << 17, 9 << 15};
  for (int i = 0; i < 4; ++i) EXPECT_EQ(sign[i], expected[i]);
}

// A block that overlaps the next one by two samples gives the same column as one block.
TEST(HighPassedSign, GoesOnFromWhereTheNextBlockBegins) {
  int32_t whole[12] = {1, 1, -1, -1, 1, 1, 1, -1, 1, 1, -1, 1}, first[8], second[6];
  for (int32_t& sign : whole) sign *= 1 << 20;
  for (int i = 0; i < 8; ++i) first[i] = whole[i];
  for (int i = 0; i < 6; ++i) second[i] = whole[6 + i];
  HighPassedSign one, two;
  one.fill(3, 3, 0, 12, 12, Column<PassedSign>(whole));
  two.fill(3, 3, 0, 8, 6, Column<PassedSign>(first));
  two.fill(3, 3, 0, 6, 6, Column<PassedSign>(second));
  for (int i = 0; i < 8; ++i) EXPECT_EQ(first[i], whole[i]);
  for (int i = 0; i < 6; ++i) EXPECT_EQ(second[i], whole[6 + i]);
}

}  // namespace
