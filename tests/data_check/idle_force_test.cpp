// A force that stands still while the motion gains energy.
#include "host_sim/data_check/drive/idle_force.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using host_sim::Quantity;
using host_sim::Record;
using host_sim::data_check::find_idle_force;
using host_sim::data_check::Weight;

constexpr double kPi = 3.14159265358979323846;

// 20 s at 100 Hz: a torque and a speed (or a displacement) as functions of time.
template <typename Force, typename Motion>
Record made(Force force, Motion motion, Quantity of = Quantity::kVelocity) {
  Record record;
  record.file = "made.csv", record.sample_period_s = 0.01;
  record.channels = {{"torque_1_N_m", Quantity::kForce, 1, {}},
                     {of == Quantity::kVelocity ? "angular_velocity_1_rad_s" : "angle_1_rad", of, 1, {}}};
  for (int i = 0; i < 2000; ++i)
    record.channels[0].values.push_back(force(0.01 * i)), record.channels[1].values.push_back(motion(0.01 * i));
  return record;
}

double until_8_s(double t) { return t < 8 ? 1 + 0.1 * std::sin(3 * t) : 0.0; }

TEST(IdleForce, WhileAnotherMotorDrives) {
  // From 8 to 20 s nought; the speed falls to 2 rad/s there and climbs by 1 rad/s each second from 10 s on, to 12. Tenths of 1.2 s: the
  // mean squares from 2^2 on to 11.4^2 are 32 times.
  const auto speed = [](double t) { return t < 8 ? 6.0 : t < 10 ? 6 - 2 * (t - 8) : 2 + (t - 10); };
  const auto found = find_idle_force(made(until_8_s, speed));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, "work");
  EXPECT_EQ(found->weight, Weight::kDoubt);
  EXPECT_EQ(found->channel, "torque_1_N_m");
  EXPECT_GT(*found->value, 10);
  EXPECT_NE(found->detail.find("stands at 0 from 8 to 20 s"), std::string::npos) << found->detail;
  // An angle tells it as well: its mean squares about the means of the tenths are those of the speed.
  const auto angle = [](double t) {
    return t < 8    ? 6 * t
           : t < 10 ? 48 + 6 * (t - 8) - (t - 8) * (t - 8)
                    : 56 + 2 * (t - 10) + 0.5 * (t - 10) * (t - 10);
  };
  EXPECT_TRUE(find_idle_force(made(until_8_s, angle, Quantity::kDisplacement)));
  // A torque that stands at -0.2 brakes: it explains no gain. One of 0.2 does.
  const auto held = [](double value) { return [=](double t) { return t < 8 ? until_8_s(t) : value; }; };
  EXPECT_TRUE(find_idle_force(made(held(-0.2), speed)));
  EXPECT_FALSE(find_idle_force(made(held(0.2), speed)));
}

TEST(IdleForce, IsNoReleaseBlowNorCoastDown) {
  const auto nought = [](double) { return 0.0; };
  const auto decay = [](double t) { return t < 8 ? std::sin(9 * t) : std::exp(-(t - 8) / 4) * std::sin(9 * t); };
  const auto coast = [](double t) { return t < 8 ? 6.0 : 6 * std::exp(-(t - 8) / 5); };
  for (const auto of : {Quantity::kVelocity, Quantity::kDisplacement})
    EXPECT_FALSE(find_idle_force(made(until_8_s, decay, of)));
  EXPECT_FALSE(find_idle_force(made(until_8_s, coast)));
  // blows at 2 and 11 s, each with its decay; the force is nought between them
  const auto blow = [](double t) { return std::fmod(t + 7, 9.0) < 0.02 ? 100.0 : 0.0; };
  const auto ring = [](double t) { return t < 2 ? 0.0 : std::exp(-std::fmod(t + 7, 9.0) / 2) * std::sin(40 * t); };
  EXPECT_FALSE(find_idle_force(made(blow, ring)));
  // beats with a hidden mass: energy comes back, less each time
  const auto beats = [](double t) {
    return t < 8 ? std::sin(9 * t) : std::exp(-(t - 8) / 30) * std::cos(0.5 * (t - 8)) * std::sin(9 * t);
  };
  EXPECT_FALSE(find_idle_force(made(until_8_s, beats)));
  // at rest before the test begins, but for noise that grows a little
  const auto late = [](double t) { return t < 8 ? 0.0 : std::sin(9 * t); };
  const auto still = [](double t) { return t < 8 ? 1e-3 * (1 + t) * std::sin(31 * t) : std::sin(9 * t + 1); };
  EXPECT_FALSE(find_idle_force(made(late, still)));
  EXPECT_FALSE(find_idle_force(made(nought, still)));  // no force at all: growth.hpp
}

TEST(IdleForce, IsNoCommandInSteps) {
  // Torques of 0.2, 0.4 .. 1 N m for 4 s each; the speed follows as 10 T (1 - exp(-t / 2 s)).
  const auto step = [](double t) { return 0.2 * (1 + std::floor(t / 4)); };
  const auto speed = [](double t) { return 2 * std::floor(t / 4) + 2 * (1 - std::exp(-std::fmod(t, 4.0) / 2)); };
  EXPECT_FALSE(find_idle_force(made(step, speed)));
}

}  // namespace
