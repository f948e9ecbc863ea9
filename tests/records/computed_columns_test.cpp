// Columns that a user computed from others, told from those of sensors.
#include "host_sim/records/derived/computed_columns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

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

}  // namespace
