// Turns of encoders that count over, joined; and jumps that are something else, left alone.
#include "host_sim/records/turns/joined_turns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace {

using host_sim::Quantity;
using host_sim::Record;

constexpr double kPi = 3.14159265358979323846;

Record record_of(const std::function<double(double)>& angle, Quantity quantity = Quantity::kDisplacement) {
  Record record;
  record.sample_period_s = 0.01;
  record.channels.push_back({});
  record.channels[0].name = "angle_1_rad", record.channels[0].quantity = quantity;
  for (int i = 0; i < 1000; ++i) record.channels[0].values.push_back(angle(0.01 * i));
  return record;
}

// What an encoder of -half to half reads.
double read(double angle, double half) { return std::remainder(angle, 2 * half); }

// 3 rad/s for 10 s, with a swing: 30 rad and back by none: read as -pi to pi.
double motion(double t) { return 3 * t + 0.5 * std::sin(2 * t); }

TEST(JoinedTurns, AreTheMotionAgain) {
  for (const double half : {kPi, 12.5 / 2, 2.0}) {
    Record record = record_of([&](double t) { return read(motion(t), half); });
    host_sim::join_turns(record);
    ASSERT_EQ(record.notes.size(), 1u) << half;
    EXPECT_NE(record.notes[0].find("counts over"), std::string::npos);
    for (int i = 0; i < 1000; ++i)
      ASSERT_NEAR(record.channels[0].values[static_cast<size_t>(i)], motion(0.01 * i), 0.02 * half) << half << " " << i;
  }
}

// A pendulum that swings about the place where its encoder counts over: it turns round beyond it.
TEST(JoinedTurns, OfASwingAboutTheSeam) {
  const auto swing = [](double t) { return kPi + 1.2 * std::cos(2 * kPi * t); };
  Record record = record_of([&](double t) { return read(swing(t), kPi); });
  host_sim::join_turns(record);
  EXPECT_EQ(record.notes.size(), 1u);
  const double turn = record.channels[0].values[0] - swing(0);  // where it begins a whole turn may be missing
  EXPECT_NEAR(turn, -2 * kPi, 1e-9);
  for (int i = 0; i < 1000; ++i)
    ASSERT_NEAR(record.channels[0].values[static_cast<size_t>(i)] - turn, swing(0.01 * i), 1e-9);
}

TEST(JoinedTurns, LeaveOtherJumpsAlone) {
  const auto untouched = [](const std::function<double(double)>& signal, Quantity quantity = Quantity::kDisplacement) {
    Record record = record_of(signal, quantity);
    const std::vector<double> before = record.channels[0].values;
    host_sim::join_turns(record);
    return record.notes.empty() && record.channels[0].values == before;
  };
  EXPECT_TRUE(untouched([](double t) { return std::sin(5 * t); }));
  EXPECT_TRUE(untouched([](double t) { return std::sin(5 * t) > 0 ? 1.0 : -1.0; }));  // a square wave
  EXPECT_TRUE(untouched([](double t) { return std::fmod(t, 1.0) < 0.05 ? 0.0 : 3 + std::sin(5 * t); }));  // dropouts
  EXPECT_TRUE(untouched([](double t) { return t < 5 ? std::sin(5 * t) : 8 + std::sin(5 * t); }));  // a step, once
  EXPECT_TRUE(untouched([](double t) { return read(motion(t), kPi); }, Quantity::kVelocity));
  EXPECT_TRUE(untouched([](double t) {  // jumps of two sizes
    return motion(t) - (t > 2 ? 5.0 : 0.0) - (t > 6 ? 9.0 : 0.0);
  }));
}

}  // namespace
