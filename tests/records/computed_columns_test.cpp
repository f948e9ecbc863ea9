// Columns that a user computed from others, told from those of sensors.
#include "host_sim/records/derived/computed_columns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host_sim/records/derived/noise_variance.hpp"

namespace {

using host_sim::Quantity;
using host_sim::Record;
using Values = std::vector<double>;

constexpr double kStep_s = 0.002;
constexpr size_t kRows = 4000;

Values noisy(const Values& of, double rms, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, rms);
  Values y = of;
  for (double& value : y) value += noise(random);
  return y;
}

// x = sin 10 t + 0.4 sin 37 t, its slope and the slope of that.
struct Motion {
  Values x, v, a;
  Motion() {
    for (size_t i = 0; i < kRows; ++i) {
      const double t = static_cast<double>(i) * kStep_s;
      x.push_back(std::sin(10 * t) + 0.4 * std::sin(37 * t));
      v.push_back(10 * std::cos(10 * t) + 14.8 * std::cos(37 * t));
      a.push_back(-100 * std::sin(10 * t) - 547.6 * std::sin(37 * t));
    }
  }
};

// numpy.gradient: central differences, at the ends to the neighbour.
Values gradient(const Values& x) {
  Values y(x.size());
  for (size_t i = 0; i < x.size(); ++i) {
    const size_t before = i == 0 ? 0 : i - 1, behind = i + 1 == x.size() ? i : i + 1;
    y[i] = (x[behind] - x[before]) / (static_cast<double>(behind - before) * kStep_s);
  }
  return y;
}

Record record_of(const Values& x, const Values& v, const Values& a) {
  Record record;
  record.sample_period_s = kStep_s;
  const auto add = [&](const char* name, Quantity quantity, const Values& values) {
    if (values.empty()) return;
    host_sim::Channel channel;
    channel.name = name, channel.quantity = quantity, channel.values = values;
    record.channels.push_back(channel);
  };
  add("force_1_N", Quantity::kForce, Values(kRows, 1.0));
  add("displacement_1_m", Quantity::kDisplacement, x);
  add("velocity_1_m_s", Quantity::kVelocity, v);
  add("acceleration_1_m_s2", Quantity::kAcceleration, a);
  return record;
}

// Names of what is left, and the notes.
std::string left_of(Record record) {
  host_sim::leave_out_computed(record);
  std::string text;
  for (const host_sim::Channel& channel : record.channels) text += channel.name.substr(0, 1);
  for (const std::string& note : record.notes) text += "; " + note;
  return text;
}

TEST(ComputedColumns, SlopesAreLeftOut) {
  const Motion motion;
  const Values x = noisy(motion.x, 1e-3, 1), v = gradient(x);
  EXPECT_EQ(
      left_of(record_of(x, v, {})),
      "fd; velocity_1_m_s: was computed from displacement_1_m (central differences) and measures nothing of its own: "
      "left out");
  EXPECT_EQ(left_of(record_of(x, v, gradient(v))).substr(0, 3), "fd;");
  Values forward(kRows, 0.0), second(kRows, 0.0);
  for (size_t i = 0; i + 1 < kRows; ++i) forward[i] = (x[i + 1] - x[i]) / kStep_s;
  for (size_t i = 1; i + 1 < kRows; ++i) second[i] = (x[i + 1] - 2 * x[i] + x[i - 1]) / (kStep_s * kStep_s);
  EXPECT_EQ(left_of(record_of(x, forward, {})).substr(0, 3), "fd;");
  EXPECT_EQ(left_of(record_of(x, {}, second)).substr(0, 3), "fd;");
  EXPECT_EQ(left_of(record_of(x, noisy(motion.v, 0.1, 2), second)).substr(0, 4), "fdv;");
}

TEST(ComputedColumns, SumsAreLeftOut) {
  const Motion motion;
  const Values a = noisy(motion.a, 5, 3);
  Values v(kRows, 0.0);
  for (size_t i = 1; i < kRows; ++i) v[i] = v[i - 1] + 0.5 * kStep_s * (a[i] + a[i - 1]);
  EXPECT_EQ(left_of(record_of({}, v, a)).substr(0, 3), "fa;");
}

// Written with as few digits as a file has: the displacement after its slope was taken.
TEST(ComputedColumns, RoundingHidesNothing) {
  const Motion motion;
  Values x = noisy(motion.x, 1e-3, 4), v = gradient(x);
  for (double& value : x) value = std::round(value * 1e5) / 1e5;
  for (double& value : v) value = std::round(value * 1e4) / 1e4;
  EXPECT_EQ(left_of(record_of(x, v, {})).substr(0, 3), "fd;");
}

// Sensors of their own: as noisy, much better, and of a simulation without any noise but that of seven digits.
TEST(ComputedColumns, SensorsStay) {
  const Motion motion;
  EXPECT_EQ(left_of(record_of(noisy(motion.x, 1e-3, 5), noisy(motion.v, 0.1, 6), noisy(motion.a, 5, 7))), "fdva");
  EXPECT_EQ(left_of(record_of(noisy(motion.x, 1e-2, 8), noisy(motion.v, 1e-4, 9), noisy(motion.a, 1e-3, 10))), "fdva");
  EXPECT_EQ(left_of(record_of(noisy(motion.x, 1e-7, 11), noisy(motion.v, 1e-1, 12), {})), "fdv");
  EXPECT_EQ(left_of(record_of(motion.x, motion.v, motion.a)), "fdva");
  Record rounded = record_of(motion.x, motion.v, motion.a);
  for (host_sim::Channel& channel : rounded.channels)
    for (double& value : channel.values) value = std::round(value * 1e6) / 1e6;
  EXPECT_EQ(left_of(rounded), "fdva");
}

// x and v at steps of 8, 10 and 12 ms in turn, the tachometer off by 0.1 %. Differences of the rows, not of the motion over the times, would
// find (0.002 s v)^2 of noise in x, and an own noise of 20 times that of a central difference, 1e-5 sqrt(2) / 20 ms = 7e-4 rad/s, within it.
TEST(ComputedColumns, UnevenStepsAreNoNoise) {
  Record record = record_of({}, {}, {});
  record.channels.clear();
  host_sim::Channel angle, rate;
  angle.name = "angle_1_rad", angle.quantity = Quantity::kDisplacement;
  rate.name = "angular_velocity_1_rad_s", rate.quantity = Quantity::kVelocity;
  double t = 0;
  for (size_t i = 0; i < kRows; ++i) {
    record.time_s.push_back(t += (i % 3 == 0 ? 0.008 : i % 3 == 1 ? 0.010 : 0.012));
    angle.values.push_back(std::sin(1.3 * t) + 0.4 * std::sin(3.3 * t));
    rate.values.push_back(1.001 * (1.3 * std::cos(1.3 * t) + 1.32 * std::cos(3.3 * t)));
  }
  angle.values = noisy(angle.values, 1e-5, 13), rate.values = noisy(rate.values, 1.4e-2, 14);
  record.channels = {angle, rate};
  EXPECT_EQ(left_of(record), "aa");
  Values& x = record.channels[0].values;
  Values& v = record.channels[1].values;
  for (size_t i = 1; i + 1 < kRows; ++i) {  // the slope of the parabola through three rows is left out as before
    const double before = record.time_s[i] - record.time_s[i - 1], behind = record.time_s[i + 1] - record.time_s[i];
    v[i] = (before * (x[i + 1] - x[i]) / behind + behind * (x[i] - x[i - 1]) / before) / (before + behind);
  }
  EXPECT_EQ(left_of(record).substr(0, 2), "a;");
}

// 0.5 Hz at 1 kHz and a little white noise of 0.01: what is found is its variance, at even steps and at steps of 0.7 and 1.3 ms.
TEST(NoiseVariance, WhateverTheSteps) {
  for (const double uneven : {0.0, 3e-4}) {
    Values t, x;
    for (size_t i = 0; i < kRows; ++i) {
      t.push_back(1e-3 * static_cast<double>(i) + (i % 2 == 0 ? 0 : uneven));
      x.push_back(std::sin(M_PI * t.back()));
    }
    EXPECT_LT(host_sim::noise_variance(x, t), 1e-24) << uneven;
    EXPECT_NEAR(host_sim::noise_variance(noisy(x, 0.01, 15), t), 1e-4, 1e-5) << uneven;
  }
  EXPECT_EQ(host_sim::noise_variance(Values(32, 1.0), Values(32, 1.0)), 0.0);
}

}  // namespace
