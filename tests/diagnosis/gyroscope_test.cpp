// Rates of what swings freely, read by a gyroscope whose zero is off, as most are.
#include <algorithm>
#include <cmath>
#include <random>

#include "two_masses.hpp"

namespace {

constexpr double kRate_Hz = 500;
constexpr double kViscous = 0.03, kCoulomb = 0.02;  // N m s/rad and N m, per unit inertia

// Leapfrog, 50 steps a sample; friction takes what rate it can and no more.
host_sim::Record let_go(double stiffness_N_m_rad, double angle_rad, double rate_rad_s, double duration_s,
                        double zero_rad_s, double noise_rad_s) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise(0, noise_rad_s);
  std::vector<double> read;
  double x = angle_rad, v = rate_rad_s;
  const double h = 1 / (kRate_Hz * 50);
  for (int k = 0; k < static_cast<int>(kRate_Hz * duration_s); ++k) {
    read.push_back(v + zero_rad_s + noise(random));
    for (int i = 0; i < 50; ++i) {
      x += 0.5 * h * v;
      v -= h * (stiffness_N_m_rad * x + kViscous * v);
      v = std::copysign(std::max(0.0, std::abs(v) - h * kCoulomb), v);
      x += 0.5 * h * v;
    }
  }
  host_sim::Record record;
  record.file = "gyroscope.csv", record.sample_period_s = 1 / kRate_Hz;
  record.channels = {{"angular_velocity_1_rad_s", host_sim::Quantity::kVelocity, 1, read}};
  return record;
}

rig_file::RigModel rig_with(bool spring) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].rotating = true, rig.dofs[0].mass_kg.value = 1;
  rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
  rig.links[0].stiffness_N_m.estimate = spring;
  rig.links[0].viscous_N_s_m.estimate = rig.links[0].coulomb_N.estimate = true;
  return rig;
}

// A wheel on a torsion bar: 4.6 s, three periods, the zero off by 7 % of the rms. Two dampings of so short a decay are told together.
TEST(Gyroscope, ItsZeroIsNoMotionOfWhatASpringHolds) {
  const diagnosis::Diagnosis d = diagnosis::diagnose(rig_with(true), {let_go(19.3, 0.15, 0, 4.6, -0.03, 0.007)}, {});
  EXPECT_EQ(two_masses::said(d), "none");
  const diagnosis::Parameter k = two_masses::parameter_of(d.baseline, "stiffness[1-0]");
  EXPECT_NEAR(k.value, 19.3, 0.1);
  EXPECT_LT(std::abs(k.value - 19.3), 4 * k.std);
  for (const auto& [name, truth] : {std::pair("viscous[1-0]", kViscous), std::pair("coulomb[1-0]", kCoulomb)}) {
    const diagnosis::Parameter p = two_masses::parameter_of(d.baseline, name);
    EXPECT_LT(std::abs(p.value - truth), 4 * p.std) << name;
  }
  ASSERT_EQ(d.baseline.holdout_nrmse_percent.size(), 1u);
  EXPECT_LT(d.baseline.holdout_nrmse_percent[0], 3);
}

// A flywheel that nothing holds: its mean rate is motion, and what damps it shows in it.
TEST(Gyroscope, TheMeanRateOfAFlywheelIsMotion) {
  const diagnosis::Diagnosis d = diagnosis::diagnose(rig_with(false), {let_go(0, 0, 3, 40, 0, 0.003)}, {});
  EXPECT_EQ(two_masses::said(d), "none");
  EXPECT_NEAR(two_masses::value_of(d.baseline, "viscous[1-0]"), kViscous, 0.05 * kViscous);
  EXPECT_NEAR(two_masses::value_of(d.baseline, "coulomb[1-0]"), kCoulomb, 0.05 * kCoulomb);
}

}  // namespace
