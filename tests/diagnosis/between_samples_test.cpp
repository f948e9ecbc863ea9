// Values between samples, against the sines they were taken from.
#include "host_sim/diagnosis/band/between_samples.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace diagnosis::runs;

constexpr double kTurn = 6.283185307179586;

Vec sine(double turns_per_sample, Index samples) {
  Vec y(samples);
  for (Index i = 0; i < samples; ++i) y[i] = std::sin(kTurn * turns_per_sample * static_cast<double>(i) + 0.4);
  return y;
}
double sine_at(double turns_per_sample, double sample) { return std::sin(kTurn * turns_per_sample * sample + 0.4); }

// Four samples a turn are what a force of 50 Hz has at 200 Hz.
TEST(BetweenSamples, AreThoseOfTheSineUpToAThirdOfTheSamplingRate) {
  for (const double turns : {0.01, 0.1, 0.25, 0.35}) {
    const Vec y = sine(turns, 100);
    for (const double share : {0.125, 0.25, 0.5, 0.9}) {
      const BetweenSamples between_them(share);
      for (Index k = 16; k < 80; ++k)
        EXPECT_NEAR(between_them.after(y, k), sine_at(turns, static_cast<double>(k) + share), 2e-6)
            << turns << " turns a sample, " << share;
    }
  }
}

// Halfway six samples weigh (3, -25, 150, 150, -25, 3) / 256: of a quarter turn a sample 172 cos(pi / 4) / 128 = 0.95 is left.
TEST(BetweenSamples, NearAnEndArePolynomials) {
  const Vec y = sine(0.25, 100);
  EXPECT_NEAR(BetweenSamples(0.5).after(y, 5) / sine_at(0.25, 5.5), 172 * std::cos(kTurn / 8) / 128, 1e-9);
  Vec line(40);
  for (Index i = 0; i < 40; ++i) line[i] = 3 + 2 * static_cast<double>(i);
  EXPECT_NEAR(BetweenSamples(0.3).after(line, 0), 3.6, 1e-9);
  EXPECT_NEAR(BetweenSamples(0.3).after(line, 38), 79.6, 1e-9);
}

TEST(BetweenSamples, DelaysByWholeAndBrokenSamplesEitherWay) {
  const Vec y = sine(0.2, 100);
  const Vec whole = delayed(y, 3), broken = delayed(y, 2.25), early = delayed(y, -0.75);
  for (Index i = 20; i < 80; ++i) {
    EXPECT_NEAR(whole[i], y[i - 3], 1e-12);
    EXPECT_NEAR(broken[i], sine_at(0.2, static_cast<double>(i) - 2.25), 2e-6);
    EXPECT_NEAR(early[i], sine_at(0.2, static_cast<double>(i) + 0.75), 2e-6);
  }
  EXPECT_EQ(whole[0], y[0]);
  EXPECT_EQ(early[99], y[99]);
}

TEST(BetweenSamples, FinerSeriesKeepTheirSamples) {
  const Vec y = sine(0.15, 60), fine = finer(y, 4);
  ASSERT_EQ(fine.size(), 59 * 4 + 1);
  for (Index i = 0; i < 60; ++i) EXPECT_EQ(fine[4 * i], y[i]);
  EXPECT_NEAR(fine[4 * 30 + 3], sine_at(0.15, 30.75), 2e-6);
}

TEST(BetweenSamples, WhatIsAskedAgainIsNotMadeAgain) {
  KeptFiner kept;
  const Vec y = sine(0.15, 60);
  const auto first = kept.of(y, 0, 4);
  EXPECT_EQ(kept.of(Vec(y), 0, 4), first);  // by its values, wherever they stand
  EXPECT_EQ(*first, finer(y, 4));
  EXPECT_NE(kept.of(y, 0.5, 4), first);
  EXPECT_NE(kept.of(y, 0, 2), first);
}

TEST(BetweenSamples, ASeriesThatWasChangedIsMadeAnew) {
  KeptFiner kept;
  Vec y = sine(0.15, 60);
  const auto first = kept.of(y, 0, 4);
  y[30] += 1e-9;
  EXPECT_EQ((*kept.of(y, 0, 4))[4 * 30], y[30]);
  EXPECT_EQ((*first)[4 * 30], sine(0.15, 60)[30]);  // who holds it keeps it
}

TEST(BetweenSamples, WhatWasAskedLongAgoIsLetGo) {
  KeptFiner kept;
  const Vec y = sine(0.15, 60);
  const std::weak_ptr<const Vec> first = kept.of(y, 0, 4);
  for (int i = 1; i <= 4; ++i) kept.of(y, 0.1 * i, 4);
  EXPECT_TRUE(first.expired());
}

}  // namespace
