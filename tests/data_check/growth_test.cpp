// Motion that grows though nothing drives it.
#include "host_sim/data_check/decay/growth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using host_sim::Quantity;
using host_sim::Record;
using host_sim::data_check::find_growth;

constexpr double kPi = 3.14159265358979323846;

// 20 s at 100 Hz of envelope(t) sin(2 pi 1.5 Hz t) about `zero`, with noise of 1 %.
template <typename Envelope>
Record swings(Envelope envelope, double zero = 0.0) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.01);
  Record record;
  record.file = "made.csv", record.sample_period_s = 0.01;
  record.channels.push_back({"displacement_1_m", Quantity::kDisplacement, 1, {}});
  for (int i = 0; i < 2000; ++i) {
    const double t = 0.01 * i;
    record.channels[0].values.push_back(zero + envelope(t) * std::sin(2 * kPi * 1.5 * t) + noise(random));
  }
  return record;
}

TEST(Growth, OfASwingThatAnUnrecordedCoilDrives) {
  // It settles as 1 - exp(-t / 5 s). The mean squares of the first two tenths: 0.038 and 0.20 of the last; the growth
  // counts from the second on (the first is under 5 %), and the last is 1 / 0.2 = 4.9 times as much.
  const auto found = find_growth(swings([](double t) { return 1 - std::exp(-t / 5); }));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, "work");
  EXPECT_EQ(found->channel, "displacement_1_m");
  EXPECT_NEAR(*found->value, 4.5, 0.8);
  EXPECT_NE(found->detail.find("no force is recorded"), std::string::npos);
}

TEST(Growth, IsNotARelease) {
  for (const double released_s : {0.0, 0.5, 1.9, 3.3, 5.99})
    for (const double zero : {0.0, 7.0})
      EXPECT_FALSE(
          find_growth(swings([=](double t) { return t < released_s ? 0.0 : std::exp(-(t - released_s) / 30); }, zero)))
          << released_s;
}

TEST(Growth, IsNotASecondBlowNorAnEvenMotion) {
  EXPECT_FALSE(find_growth(swings([](double t) { return std::exp(-std::fmod(t, 7.0) / 2); })));
  EXPECT_FALSE(find_growth(swings([](double t) { return t < 7 ? 0.3 * std::exp(-t / 2) : std::exp(-(t - 7) / 2); })));
  EXPECT_FALSE(find_growth(swings([](double) { return 1.0; })));
}

// A step of a command: the force is known, and does not change. A sensor that reads 5 all the time tells none.
TEST(Growth, UnderACommandThatIsHeldIsItsWork) {
  Record record = swings([](double t) { return 1 - std::exp(-t / 5); });
  record.channels.push_back({"force_1_N", Quantity::kForce, 1, std::vector<double>(2000, 5.0)});
  EXPECT_TRUE(find_growth(record));
  record.channels[1].held = true;
  EXPECT_FALSE(find_growth(record));
  record.channels[1].values.assign(2000, 0.0);
  EXPECT_TRUE(find_growth(record));
}

// Four periods of a decay: a tenth is less than half a period, and its mean square goes with the swing's phase.
TEST(Growth, IsNotTheSwingItself) {
  for (const double phase : {0.0, 0.7, 1.4, 2.1, 2.8}) {
    Record record = swings([](double) { return 0.0; });
    std::vector<double>& y = record.channels[0].values;
    for (size_t i = 0; i < y.size(); ++i)
      y[i] += std::exp(-2e-4 * static_cast<double>(i)) * std::cos(2 * kPi * 0.002 * static_cast<double>(i) + phase);
    EXPECT_FALSE(find_growth(record)) << phase;
  }
}

// A car rolls from 12 m/s, at 0.3 m/s^2 for 14 s, and is braked to rest from 7.8 m/s on within the next 4 s, ever harder: its square falls
// all along, while within the tenths of 2 s from 12 s on it varies by 0.03, 0.34 and 2.9 (m/s)^2 about their means. One that runs up the same way by
// itself is driven.
TEST(Growth, IsNotACarThatIsBraked) {
  const auto speed = [](double t) {
    return t < 14 ? 12 - 0.3 * t : t < 18 ? 7.8 * (1 - std::pow((t - 14) / 4, 2)) : 0.0;
  };
  for (const double sign : {1.0, -1.0}) {
    Record record = swings([](double) { return 0.0; });
    record.channels[0].name = "velocity_1_m_s", record.channels[0].quantity = Quantity::kVelocity;
    std::vector<double>& v = record.channels[0].values;
    for (size_t i = 0; i < v.size(); ++i) v[i] += sign * speed(0.01 * static_cast<double>(i));
    EXPECT_FALSE(find_growth(record));
    std::reverse(v.begin(), v.end());
    EXPECT_TRUE(find_growth(record));
  }
}

// A motor runs a flywheel up within 8 s, which coasts from there on: what is left of the record is the coast-down.
TEST(Growth, OfAMotorsRunUpIsLeftOut) {
  Record record = swings([](double) { return 0.0; });
  record.channels[0].name = "velocity_1_m_s", record.channels[0].quantity = Quantity::kVelocity;
  std::vector<double>& v = record.channels[0].values;
  for (size_t i = 0; i < v.size(); ++i) {
    const double t = 0.01 * static_cast<double>(i);
    v[i] += t < 8 ? 1.5 * t : 12 * std::exp((8 - t) / 4);
  }
  EXPECT_FALSE(find_growth(record));
}

TEST(Growth, TellsNothingBesideAForceABaseOrAnotherMass) {
  const Record grows = swings([](double t) { return 1 - std::exp(-t / 5); });
  Record forced = grows, carried = grows, two = grows;
  forced.channels.push_back({"force_1_N", Quantity::kForce, 1, grows.channels[0].values});
  carried.channels.push_back({"displacement_base_m", Quantity::kDisplacement, -1, grows.channels[0].values});
  two.channels.push_back({"displacement_2_m", Quantity::kDisplacement, 2, grows.channels[0].values});
  for (const Record& record : {forced, carried, two}) EXPECT_FALSE(find_growth(record));
  forced.channels[1].values.assign(forced.channels[1].values.size(), 0.0);  // a force that was never switched on
  EXPECT_TRUE(find_growth(forced));
}

}  // namespace
