// Coast-downs behind a motor's run-up: no period, and no swing about a middle.
#include "host_sim/data_check/decay/coasting.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "host_sim/data_check/decay/free_decays.hpp"

namespace {

using host_sim::Quantity;
using host_sim::Record;
using host_sim::data_check::DecaySpan;
using host_sim::data_check::free_decays;

// 100 s at 20 Hz of a speed with noise of 0.05 of its 100 rad/s, read as it is or as the angle that it sums up to.
Record record_of(const std::function<double(double)>& speed, bool angle = false, double sign = 1.0) {
  std::mt19937 random(8);
  std::normal_distribution<double> noise(0.0, 0.05);
  Record record;
  record.file = "coast.csv", record.sample_period_s = 0.05;
  record.channels = {angle ? host_sim::Channel{"angle_1_rad", Quantity::kDisplacement, 1, {}}
                           : host_sim::Channel{"angular_velocity_1_rad_s", Quantity::kVelocity, 1, {}}};
  double turned = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const double v = speed(0.05 * i);
    turned += 0.05 * v;
    record.channels[0].values.push_back(sign * (angle ? turned + 0.01 * noise(random) : v + noise(random)));
  }
  return record;
}

// Viscous and dry: dv/dt = -v / 40 s - 0.5 rad/s^2, from 100 rad/s on; at rest after 40 ln(1 + 100 / 20) = 71.7 s.
double coast(double t) { return std::max(0.0, 120 * std::exp(-t / 40) - 20); }
// A motor runs up within 10 s, and holds until 20 s.
double run_up(double t) { return t < 10 ? 10 * t : t < 20 ? 100.0 : coast(t - 20); }

// The speed has lost a fortieth after 40 ln(120 / 117.5) = 0.84 s: what is left out behind 20 s is that, and a window of 0.2 s.
TEST(Coasting, BeginsBehindTheMotorsRunUp) {
  for (const double sign : {1.0, -1.0})
    for (const bool angle : {false, true}) {
      const auto decays = free_decays(record_of(run_up, angle, sign));
      ASSERT_EQ(decays.size(), 1u) << sign << angle;
      EXPECT_GE(decays[0].from, 20u * 20);
      EXPECT_LE(decays[0].from, 20u * 20 + 17 + 8);
      EXPECT_EQ(decays[0].to, 2000u);
    }
}

// Held for 10 s at first; and from the first sample on, with drag alone, dry friction alone and both: the whole record.
TEST(Coasting, BeginsWithTheRecordUnlessItIsHeld) {
  const auto held = free_decays(record_of([](double t) { return run_up(t + 10); }));
  ASSERT_EQ(held.size(), 1u);
  EXPECT_GE(held[0].from, 10u * 20);
  for (const auto& speed : {std::function<double(double)>(coast),
                            std::function<double(double)>([](double t) { return 100 / (1 + t / 10); }),
                            std::function<double(double)>([](double t) { return std::max(0.0, 100 - 1.2 * t); })}) {
    const auto decays = free_decays(record_of(speed));
    ASSERT_EQ(decays.size(), 1u);
    EXPECT_EQ(decays[0].from, 0u);
    EXPECT_EQ(decays[0].to, 2000u);
  }
}

// Two run-ups of 5 s at 0 and 50 s: two decays, the first ends where the second run-up begins, 3 windows about it.
TEST(Coasting, OfTwoRunUpsAreTwo) {
  const auto decays = free_decays(record_of([](double t) {
    const double s = std::fmod(t, 50.0);
    return s < 5 ? 20 * s : coast(s - 5);
  }));
  ASSERT_EQ(decays.size(), 2u);
  EXPECT_GE(decays[0].from, 5u * 20);
  EXPECT_NEAR(static_cast<double>(decays[0].to), 50 * 20, 3 * 4 + 20);
  EXPECT_GE(decays[1].from, 55u * 20);
  EXPECT_LE(decays[1].from, 56u * 20 + 8);
}

// The rig stands for 20 s before and rests after it, where the sensor wanders by up to 4 % of the speed about nought (a wheel's pick-up),
// far more than its noise from sample to sample.
TEST(Coasting, StandsBeforeAndAfter) {
  const auto decays = free_decays(record_of([](double t) {
    const double v = t < 20 ? 0.0 : run_up(t - 20);
    return v > 0.0 ? v : 4 * std::sin(0.9 * t);
  }));
  ASSERT_EQ(decays.size(), 1u);
  EXPECT_GE(decays[0].from, 40u * 20);
  EXPECT_LE(decays[0].from, 40u * 20 + 17 + 8);
}

// A motor that is ramped up, held for 30 s and ramped down within 2 s decays for a tenth of its time; one that turns back does not
// keep its sign; one that slows to 60 % (36 % of the energy) shows too little.
TEST(Coasting, IsNotAMotorsOwnMotion) {
  EXPECT_TRUE(free_decays(record_of([](double t) {
                const double s = std::fmod(t, 40.0);
                return 100 * std::max(0.0, std::min({1.0, s / 2, (34 - s) / 2}));
              })).empty());
  EXPECT_TRUE(free_decays(record_of([](double t) { return 100 * std::cos(0.03 * t) - 20; })).empty());
  EXPECT_TRUE(
      free_decays(record_of([](double t) { return t < 10 ? 10 * t : 60 + 40 * std::exp((10 - t) / 5); })).empty());
}

}  // namespace
