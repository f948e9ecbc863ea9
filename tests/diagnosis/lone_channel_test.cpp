// A channel that says something else than the other channels of its DOF.
#include "host_sim/diagnosis/sensors/lone_channel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host_sim/diagnosis/diagnosis.hpp"
#include "two_masses.hpp"

namespace {

using namespace diagnosis;
using host_sim::Quantity;

TEST(LoneChannel, IsOneOfSeveralOfItsDof) {
  host_sim::Record record;
  record.channels = {{"force_1_N", Quantity::kForce, 1, {1.0}},
                     {"displacement_1_m", Quantity::kDisplacement, 1, {2.0}},
                     {"acceleration_1_m_s2", Quantity::kAcceleration, 1, {3.0}},
                     {"acceleration_2_m_s2", Quantity::kAcceleration, 2, {4.0}},
                     {"acceleration_base_m_s2", Quantity::kAcceleration, 0, {5.0}}};
  EXPECT_EQ(spared_by_others(record, Quantity::kAcceleration), std::vector<std::string>{"acceleration_1_m_s2"});
  EXPECT_EQ(spared_by_others(record, Quantity::kDisplacement), std::vector<std::string>{"displacement_1_m"});
  EXPECT_TRUE(spared_by_others(record, Quantity::kVelocity).empty());
  const auto rest = without_channels({record}, {"acceleration_1_m_s2", "force_1_N"});
  ASSERT_EQ(rest[0].channels.size(), 3u);
  EXPECT_EQ(rest[0].channels[0].name, "displacement_1_m");
  EXPECT_EQ(rest[0].channels[2].name, "acceleration_base_m_s2");
}

// 20 s at 100 Hz of sin(2 pi t), its rate times a gain, and white noise of as much of the rate.
host_sim::Record with_velocity(double gain, double noise_share) {
  std::mt19937 random(8);
  std::normal_distribution<double> noise;
  std::vector<double> x, v;
  for (int k = 0; k < 2000; ++k) {
    const double turn = 2 * M_PI * k / 100.0;
    x.push_back(std::sin(turn) + 1e-3 * noise(random));
    v.push_back(2 * M_PI * (gain * std::cos(turn) + noise_share * noise(random)));
  }
  host_sim::Record record;
  record.sample_period_s = 1 / 100.0;
  record.channels = {{"displacement_1_m", Quantity::kDisplacement, 1, x},
                     {"velocity_1_m_s", Quantity::kVelocity, 1, v}};
  return record;
}

// A channel with much noise of high frequency tells the same motion; one of other units, or turned round, does not.
TEST(LoneChannel, GoesWithTheOthersWhereItTellsTheSameMotion) {
  rig_file::RigModel rig;
  rig.dofs.resize(1);
  const auto goes = [&](double gain, double noise_share) {
    return go_with_the_others(rig, {with_velocity(gain, noise_share)}, {"velocity_1_m_s"});
  };
  EXPECT_TRUE(goes(1, 0));
  EXPECT_TRUE(goes(1, 0.4));
  EXPECT_TRUE(goes(0.95, 0.1));
  EXPECT_FALSE(goes(-1, 0));
  EXPECT_FALSE(goes(0.7, 0));
  EXPECT_FALSE(goes(9.81, 0));
}

// 0.2 kg on 14.45 N/m (1.353 Hz) with 0.003 N s/m (a time constant of 133 s), let go at 5 cm: 40 s at 200 Hz. Displacement to 0.1 mm. The
// accelerometer's cable hums: 1 m/s^2 at 14.8 Hz, where the motion's own is 3.6.
host_sim::Record humming_decay(bool with_acceleration) {
  const double mass = 0.2, stiffness = 14.45, viscous = 0.003, half = viscous / (2 * mass);
  const double omega = std::sqrt(stiffness / mass - half * half);
  std::mt19937 random(5);
  std::normal_distribution<double> noise;
  std::vector<double> x, a;
  for (int k = 0; k < 8000; ++k) {
    const double t = k / 200.0, swing = 0.05 * std::exp(-half * t) * std::cos(omega * t);
    x.push_back(swing + 1e-4 * noise(random));
    a.push_back(std::sin(2 * M_PI * 14.8 * t) * (40 + 8 * noise(random)));
  }
  host_sim::Record record;
  record.sample_period_s = 1 / 200.0;
  record.channels = {{"displacement_1_m", Quantity::kDisplacement, 1, x}};
  if (with_acceleration) record.channels.push_back({"acceleration_1_m_s2", Quantity::kAcceleration, 1, a});
  return record;
}

TEST(LoneChannel, IsLeftOutWhereTheRigDescribesTheOthers) {
  rig_file::RigModel rig;
  rig.dofs.resize(1);
  rig.dofs[0].mass_kg.value = 0.2;
  rig.links.resize(1);
  rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
  rig.links[0].stiffness_N_m.estimate = rig.links[0].viscous_N_s_m.estimate = true;
  const Diagnosis d = diagnose(rig, {humming_decay(true)}, {}, {});
  EXPECT_EQ(d.cannot_describe, "");
  EXPECT_EQ(d.channels_left_out, std::vector<std::string>{"acceleration_1_m_s2"});
  const Parameter stiffness = two_masses::parameter_of(d.baseline, "stiffness[1-0]"),
                  viscous = two_masses::parameter_of(d.baseline, "viscous[1-0]");
  EXPECT_NEAR(stiffness.value, 14.45, 4 * stiffness.std + 1e-3);
  EXPECT_NEAR(viscous.value, 0.003, 4 * viscous.std + 3e-5);
  EXPECT_TRUE(diagnose(rig, {humming_decay(false)}, {}, {}).channels_left_out.empty());
}

}  // namespace
