// A motion that is held is flat too: its other channels tell it from a range that ends.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "host_sim/data_check/flat/clipping.hpp"

namespace {

using host_sim::Quantity;
using host_sim::Record;
using host_sim::data_check::find_clipping;
using host_sim::data_check::Finding;
using host_sim::data_check::statistics_of;

// A speed loop of 4 ms on eight trapezoids: of 1.5 s, 0.3 s of rest, 0.1 s up to 20 rad/s, 0.5 s there, 0.1 s down, rest.
// J = 1 kg m^2, friction of 2 N m. At 500 Hz, with white noise of `noise` rad/s and 1 rad/s^2; the sensor of the speed ends at
// `limit` in front of that noise. Both corners of a limit of 14 are passed at 200 rad/s^2: 6 rad/s are missing for 0.56 s of
// each 1.5 s, less what is lost where noise parts a flat stretch.
Record servo(double noise, bool accelerometer, double limit = 1e9) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  Record record;
  record.file = "servo.csv", record.sample_period_s = 0.002;
  record.channels = {{"torque_1_N_m", Quantity::kForce, 1, {}},
                     {"angular_velocity_1_rad_s", Quantity::kVelocity, 1, {}}};
  if (accelerometer) record.channels.push_back({"angular_acceleration_1_rad_s2", Quantity::kAcceleration, 1, {}});
  double v = 0.0;
  for (int i = 0; i < 6000; ++i) {
    const double t = std::fmod(0.002 * i, 1.5);
    const double command = 20.0 * std::clamp(std::min((t - 0.3) / 0.1, (1.0 - t) / 0.1), 0.0, 1.0);
    const double next = command + (v - command) * std::exp(-0.5), a = (next - v) / 0.002;
    record.channels[0].values.push_back(a + 2.0 * std::tanh(v / 0.1) + 0.05 * normal(random));
    record.channels[1].values.push_back(std::min(v, limit) + noise * normal(random));
    if (accelerometer) record.channels[2].values.push_back(a + normal(random));
    v = next;
  }
  return record;
}

std::optional<Finding> clipping_of_speed(const Record& record) {
  return find_clipping(record.channels[1], statistics_of(record.channels[1]), 0.0, 0.0, &record);
}

TEST(Plateau, OfASpeedThatIsHeldIsNotClipped) {
  for (const double noise : {0.0, 1e-6, 0.03, 0.1, 0.3})
    for (const bool accelerometer : {false, true})
      EXPECT_FALSE(clipping_of_speed(servo(noise, accelerometer))) << noise << " " << accelerometer;
  // the noise alone does not say so: without what stands beside it a plateau is a range that ends
  const Record alone = servo(0.1, false);
  EXPECT_TRUE(find_clipping(alone.channels[1], statistics_of(alone.channels[1]), 0.0, 0.0));
}

TEST(Plateau, BelowWhichTheAccelerationGoesOnIsClipped) {
  for (const double noise : {0.03, 0.1, 0.3}) {
    const auto found = clipping_of_speed(servo(noise, true, 14.0));
    ASSERT_TRUE(found) << noise;
    EXPECT_EQ(found->weight, host_sim::data_check::Weight::kFault);
    EXPECT_GT(*found->value, 0.2) << noise;
    EXPECT_LT(*found->value, 0.56 / 1.5) << noise;
  }
}

// A swing of 1 Hz whose crests are cut off at 0.7, with noise of 1 % behind that: under a force in phase with the speed, which
// hardly changes at its crest, and behind a blow, when no force acts.
TEST(Plateau, OfASwingWhoseForceRestsIsClipped) {
  std::mt19937 random(12);
  std::normal_distribution<double> normal;
  for (const bool driven : {true, false}) {
    Record record;
    record.file = "swing.csv", record.sample_period_s = 0.005;
    record.channels = {{"force_1_N", Quantity::kForce, 1, {}}, {"velocity_1_m_s", Quantity::kVelocity, 1, {}}};
    for (int i = 0; i < 4000; ++i) {
      const double swing = std::sin(2 * M_PI * 0.005 * i);
      record.channels[0].values.push_back((driven ? 5 * swing : i < 5 ? 100.0 : 0.0) + 0.02 * normal(random));
      record.channels[1].values.push_back(std::clamp(swing, -0.7, 0.7) + 0.01 * normal(random));
    }
    EXPECT_TRUE(clipping_of_speed(record)) << driven;
  }
}

// A speed in pulses of one direction, between which the rig stands: its lowest values are the noise of rest.
TEST(Plateau, OfRestAtZeroIsNoEndOfARange) {
  std::mt19937 random(13);
  std::normal_distribution<double> normal(0.0, 0.02);
  host_sim::Channel speed{"velocity_1_m_s", Quantity::kVelocity, 1, {}};
  for (int i = 0; i < 6000; ++i) {
    const double t = 0.001 * (i % 600), pulse = std::sin(M_PI * t / 0.4);
    speed.values.push_back((t < 0.4 ? 10 * pulse : 0.0) + normal(random));
  }
  EXPECT_FALSE(find_clipping(speed, statistics_of(speed), 0.0, 0.0));
}

}  // namespace
