// Rates that were made of an encoder's steps, told from those of a sensor.
#include "host_sim/records/derived/of_rounding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using Values = std::vector<double>;

constexpr double kTick_rad = 0.00314, kPeriod_s = 0.0067;
constexpr size_t kRows = 3000;

// A pendulum of 0.8 s that starts at 1 rad and dies out, after 5 s of rest: what an encoder of 2000 ticks a turn reads, and its true rate.
struct Swing {
  Values t, x, v;
  explicit Swing(double tick = kTick_rad) {
    for (size_t i = 0; i < kRows; ++i) {
      t.push_back(static_cast<double>(i) * kPeriod_s);
      const double since = t.back() - 5, e = std::exp(-0.2 * since), w = 7.85;
      x.push_back(since < 0 ? 1 : e * std::cos(w * since));
      v.push_back(since < 0 ? 0 : -e * (0.2 * std::cos(w * since) + w * std::sin(w * since)));
      x.back() = tick * std::round(x.back() / tick);
    }
  }
};

Values difference(const Swing& s) {
  Values y(kRows, 0.0);
  for (size_t i = 1; i < kRows; ++i) y[i] = (s.x[i] - s.x[i - 1]) / kPeriod_s;
  return y;
}

bool follows(const Values& column, const Swing& s) {
  host_sim::Channel rate, angle;
  rate.values = column, angle.values = s.x;
  return host_sim::follows_rounding(rate, angle, s.t);
}

TEST(OfRounding, SmoothedDifferences) {
  const Swing s;
  const Values d = difference(s);
  Values weighted(kRows, 0.0), mean(kRows, 0.0), low(kRows, 0.0);
  for (size_t i = 16; i < kRows; ++i) {
    weighted[i] = 0.3 * d[i] + 0.4 * d[i - 1] + 0.3 * d[i - 2];
    for (size_t k = 0; k < 9; ++k) mean[i] += d[i - k] / 9;
    low[i] = 0.85 * low[i - 1] +
             0.15 * d[i];  // a filtered derivative: it remembers further than the rows that are looked at
  }
  EXPECT_TRUE(follows(d, s));
  EXPECT_TRUE(follows(weighted, s));
  EXPECT_TRUE(follows(mean, s));
  EXPECT_TRUE(follows(low, s));
}

// Taken at another instant than the row's: one in 25 is a tick more, the next one less.
TEST(OfRounding, DifferencesThatAreATickOffNowAndThen) {
  const Swing s;
  Values d = difference(s);
  std::mt19937 random(3);
  for (size_t i = 800; i + 1 < kRows; ++i)
    if (random() % 50 == 0) d[i] += kTick_rad / kPeriod_s, d[i + 1] -= kTick_rad / kPeriod_s;
  EXPECT_TRUE(follows(d, s));
}

// Even one that knows the rate exactly does not know where between two ticks the encoder is.
TEST(OfRounding, SensorsDoNot) {
  const Swing s;
  EXPECT_FALSE(follows(s.v, s));
  std::mt19937 random(7);
  for (const double rms : {1e-4, 1e-2, 0.3}) {
    std::normal_distribution<double> noise(0, rms);
    Values v = s.v;
    for (double& value : v) value += noise(random);
    EXPECT_FALSE(follows(v, s)) << rms;
  }
  Values coarse = s.v;  // a gyroscope of 0.02 rad/s
  for (double& value : coarse) value = 0.02 * std::round(value / 0.02);
  EXPECT_FALSE(follows(coarse, s));
}

// An angle that is written with six decimals, and one without steps at all.
TEST(OfRounding, FineSteps) {
  for (const double tick : {1e-6, 1e-12}) {
    const Swing s(tick);
    EXPECT_FALSE(follows(s.v, s)) << tick;
  }
}

// Constant speed, as of a motor: ticks in even turn, and the rate of a tachometer beside it.
TEST(OfRounding, AMotorAtSpeed) {
  Swing s;
  std::mt19937 random(9);
  std::normal_distribution<double> noise(0, 0.002);
  for (size_t i = 0; i < kRows; ++i) {
    s.x[i] = kTick_rad * std::floor(0.8 * s.t[i] / kTick_rad);
    s.v[i] = 0.8 + noise(random);
  }
  EXPECT_FALSE(follows(s.v, s));
  EXPECT_TRUE(follows(difference(s), s));
}

// A sine that is locked to the sampling, without noise: the same few rows again and again, in which what the encoder reads and what it is
// rounded by is a function of the sine. Any column of that period follows it.
TEST(OfRounding, LockedSinesTellNothing) {
  for (const size_t period : {8, 16, 20, 24, 25, 40, 100, 200}) {
    Swing s;
    Values a(kRows);
    for (size_t i = 0; i < kRows; ++i) {
      const double phase = 2 * M_PI * static_cast<double>(i % period) / static_cast<double>(period);
      s.x[i] = kTick_rad * std::round(0.013 * std::sin(phase) / kTick_rad);
      s.v[i] = std::cos(phase), a[i] = std::round(-1e6 * std::sin(phase)) / 1e6;
    }
    EXPECT_FALSE(follows(s.v, s)) << period;
    EXPECT_FALSE(follows(a, s)) << period;
  }
}

}  // namespace
