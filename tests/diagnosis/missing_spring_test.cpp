// Two masses in a chain, and a hose from the second to the ground that the rig file knows nothing of. The plant is the test's own.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "two_masses.hpp"

namespace {

using namespace two_masses;
using host_sim::Quantity;

constexpr double kMass_kg[] = {2, 3}, kStiffness_N_m[] = {8000, 6000}, kViscous_N_s_m[] = {12, 8}, kHose_N_m = 900;

State slope_of(const State& s, double force_N) {
  const double between = kStiffness_N_m[1] * (s.x[0] - s.x[1]) + kViscous_N_s_m[1] * (s.v[0] - s.v[1]);
  State out;
  out.x[0] = s.v[0], out.x[1] = s.v[1];
  out.v[0] = (force_N - kStiffness_N_m[0] * s.x[0] - kViscous_N_s_m[0] * s.v[0] - between) / kMass_kg[0];
  out.v[1] = (between - kHose_N_m * s.x[1]) / kMass_kg[1];
  return out;
}

host_sim::Record record() {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> phase(0, 6.283185307179586);
  std::vector<double> start;
  for (int i = 0; i < 60; ++i) start.push_back(phase(random));
  const auto drive_N = [&](double t) {
    double sum = 0;
    for (size_t i = 0; i < start.size(); ++i)
      sum += std::sin(6.283185307179586 * (1 + 0.3 * static_cast<double>(i)) * t + start[i]);
    return 4 * sum;
  };
  std::vector<double> force, place[2];
  State s;
  const double h = 1e-3;
  for (int k = 0; k < 30000; ++k) {
    const double t = k * h;
    if (k % 4 == 0) {
      force.push_back(drive_N(t) + 0.1 * normal(random));
      for (int i = 0; i < 2; ++i) place[i].push_back(s.x[i] + 2e-5 * normal(random));
    }
    s = stepped(s, h, drive_N(t), drive_N(t + h / 2), drive_N(t + h), slope_of);
  }
  host_sim::Record made;
  made.file = "rig.csv", made.sample_period_s = 4e-3;
  made.channels = {{"force_1_N", Quantity::kForce, 1, force},
                   {"displacement_1_m", Quantity::kDisplacement, 1, place[0]},
                   {"displacement_2_m", Quantity::kDisplacement, 2, place[1]}};
  return made;
}

// Four other causes stood for it: a mass, two springs and a gain.
TEST(MissingSpring, ThatNoLinkOfTheRigFileHasIsNamed) {
  rig_file::RigModel rig;
  rig.dofs.resize(2), rig.links.resize(2);
  for (size_t i = 0; i < 2; ++i) {
    rig.dofs[i].mass_kg.value = kMass_kg[i];
    rig.links[i].a = 1, rig.links[i].b = i == 0 ? 0 : 2;
    rig.links[i].stiffness_N_m.value = kStiffness_N_m[i], rig.links[i].viscous_N_s_m.estimate = true;
  }
  const diagnosis::Diagnosis d = diagnosis::diagnose(rig, {record()}, {});
  ASSERT_EQ(d.causes.size(), 1u) << said(d);
  EXPECT_EQ(d.causes[0].effect + " " + d.causes[0].where, "stiffness_error link 2-0");
  EXPECT_NEAR(value_of(d.extended, "stiffness_error[2-0]"), kHose_N_m, 0.02 * kHose_N_m);
  EXPECT_NEAR(value_of(d.extended, "viscous[1-2]"), kViscous_N_s_m[1], 0.03 * kViscous_N_s_m[1]);
}

// 1.9 kg on 6800 N/m (9.52 Hz) with 5.8 N s/m, let go from x0: 3 s at 500 Hz of x = x0 e^(-a t) (cos w t + a / w sin w t), a = c / 2 m.
// Noise of 10 um.
host_sim::Record decay(double x0_m, double zero_m, unsigned seed) {
  constexpr double kA = 5.8 / 3.8;
  const double omega = std::sqrt(6800 / 1.9 - kA * kA);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0, 1e-5);
  std::vector<double> x;
  for (int k = 0; k < 1500; ++k) {
    const double t = k / 500.0;
    x.push_back(zero_m + x0_m * std::exp(-kA * t) * (std::cos(omega * t) + kA / omega * std::sin(omega * t)) +
                noise(random));
  }
  host_sim::Record made;
  made.file = "decay.csv", made.sample_period_s = 1 / 500.0;
  made.channels = {{"displacement_1_m", Quantity::kDisplacement, 1, x}};
  return made;
}

diagnosis::Diagnosis of_decays_without_the_spring(double zero_m) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].mass_kg.value = 1.9;
  rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
  rig.links[0].viscous_N_s_m.estimate = rig.links[0].coulomb_N.estimate = true;
  return diagnosis::diagnose(rig, {decay(0.01, zero_m, 1), decay(0.007, zero_m, 2), decay(0.012, zero_m, 3)}, {});
}

// Nothing pulls a free mass back in the rig file: it follows no decay.
TEST(MissingSpring, OfTheOnlyMassIsNamedInADecay) {
  const diagnosis::Diagnosis d = of_decays_without_the_spring(0);
  EXPECT_EQ(said(d), "explained, stiffness_error on link 1-0");
  EXPECT_NEAR(value_of(d.extended, "stiffness_error[1-0]"), 6800, 7);
  EXPECT_NEAR(value_of(d.extended, "viscous[1-0]"), 5.8, 0.06);
}

}  // namespace
