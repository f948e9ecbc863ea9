// A servo motor without a spring whose torque is measured, and mostly noise; what makes the noise is not right on the mean either.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "two_masses.hpp"

namespace {

using namespace two_masses;

constexpr double kInertia = 2e-4, kViscous = 2e-4, kCoulomb = 0.03;

// Two levels of torque for 10 s each at 1 kHz, the rate in steps as a differentiated encoder has it. The torque reads `off` more at
// the first level than it is, and less at the second; noise is its standard deviation.
host_sim::Record record_of(double noise, double off, uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> torques, rates;
  double rate = 0;
  for (int k = 0; k < 20000; ++k) {
    const bool first = k < 10000;
    const double torque = first ? 0.05 : 0.06;
    torques.push_back(torque + (first ? off : -off) + noise * normal(random));
    rates.push_back(0.05 * std::round(rate / 0.05));
    for (int i = 0; i < 10; ++i) {
      const double free_rate = rate + 1e-4 * (torque - kViscous * rate) / kInertia, most = 1e-4 * kCoulomb / kInertia;
      rate = std::abs(free_rate) <= most ? 0 : free_rate - std::copysign(most, free_rate);
    }
  }
  host_sim::Record record;
  record.file = "servo.csv", record.sample_period_s = 1e-3;
  record.channels = {{"torque_1_N_m", host_sim::Quantity::kForce, 1, torques},
                     {"angular_velocity_1_rad_s", host_sim::Quantity::kVelocity, 1, rates}};
  return record;
}

diagnosis::Diagnosis answer_to(double noise, double off, uint64_t seed) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].rotating = true, rig.dofs[0].mass_kg.estimate = true;
  rig.links[0].a = 1, rig.links[0].b = 0;
  rig.links[0].viscous_N_s_m.estimate = rig.links[0].coulomb_N.estimate = true;
  return diagnosis::diagnose(rig, {record_of(noise, off, seed)}, {});
}

double off_by(const diagnosis::Diagnosis& d, const char* name, double truth) {
  const diagnosis::Parameter p = parameter_of(d.baseline, name);
  return std::abs(p.value - truth) / (1.96 * p.std);
}

// Noise of half the torque, 0.027 N m, and off by 0.09 of that: between the levels the torque rises by 0.0051 N m where it rose by
// 0.01, and the viscous friction that it tells is half of what it is.
TEST(NoisyDrive, IntervalsHoldWhatATorqueIsOffOnTheMean) {
  const diagnosis::Diagnosis d = answer_to(0.027, 0.09 * 0.027, 31);
  EXPECT_TRUE(d.causes.empty()) << said(d);
  EXPECT_LT(value_of(d.baseline, "viscous[1-0]"), 0.75 * kViscous);
  EXPECT_LT(off_by(d, "mass[1]", kInertia), 1);
  EXPECT_LT(off_by(d, "viscous[1-0]", kViscous), 1);
  EXPECT_LT(off_by(d, "coulomb[1-0]", kCoulomb), 1);
}

// A torque with a hundredth of noise is an instrument: its numbers are as narrow as their scatter.
TEST(NoisyDrive, ASoundTorqueTellsNarrowly) {
  const diagnosis::Diagnosis d = answer_to(0.0005, 0, 41);
  EXPECT_LT(1.96 * parameter_of(d.baseline, "viscous[1-0]").std, 0.05 * kViscous);
  EXPECT_NEAR(value_of(d.baseline, "viscous[1-0]"), kViscous, 0.05 * kViscous);
}

}  // namespace
