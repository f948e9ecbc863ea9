// Friction that falls with the rate beside dry friction that the rig file leaves open: the two, the damper and the rate itself lie along
// one valley of the error, which sticking makes rough.
#include <gtest/gtest.h>

#include <cmath>

#include "one_mass.hpp"
#include "two_masses.hpp"

namespace {

using namespace two_masses;
using one_mass::kViscous_N_s_m;

constexpr double kCoulomb_N = 2;

struct Fall {
  double stribeck_N, velocity_m_s;
};

host_sim::Record record(const Fall& fall, uint64_t seed, int samples = 10000, double noise_m = 2e-5) {
  const auto friction_N = [&](double v) {
    return kCoulomb_N + fall.stribeck_N * std::exp(-std::abs(v) / fall.velocity_m_s);
  };
  return one_mass::record(friction_N, seed, {3.5, samples, noise_m});
}

void expect_number(const diagnosis::Diagnosis& d, const std::string& name, double truth) {
  for (const diagnosis::Parameter& p : d.extended.parameters)
    if (p.name == name) {
      EXPECT_GT(p.std, 0) << name;
      EXPECT_LT(p.std, 0.1 * truth) << name << ": no number";
      EXPECT_NEAR(p.value, truth, 0.02 * truth + 4 * p.std) << name << ": " << said(d);
      return;
    }
  ADD_FAILURE() << name << " is not told: " << said(d);
}

rig_file::RigModel open_rig() {
  rig_file::RigModel rig = one_mass::rig();
  rig.links[0].coulomb_N.estimate = true;
  return rig;
}

// Friction VALID at half and at a fifth of the truth, and the rate at which it falls without an interval.
TEST(Stribeck, BesideUnknownDryFrictionIsFoundWithItsRate) {
  for (const uint64_t seed : {11, 12, 13})
    for (const Fall fall : {Fall{3, 0.05}, Fall{2, 0.12}}) {
      const diagnosis::Diagnosis d = diagnosis::diagnose(open_rig(), {record(fall, seed)}, {});
      ASSERT_EQ(d.causes.size(), 1u) << seed << ": " << said(d);
      EXPECT_EQ(d.causes[0].effect, "stribeck") << seed << ": " << said(d);
      expect_number(d, "viscous[1-0]", kViscous_N_s_m), expect_number(d, "coulomb[1-0]", kCoulomb_N);
      expect_number(d, "stribeck[1-0]", fall.stribeck_N);
      expect_number(d, "stribeck_velocity[1-0]", fall.velocity_m_s);
    }
}

// Six seconds of a displacement with a hundredth of noise: rows of a twice derived motion see nothing, free runs miss a fiftieth of
// unseen data. It was "none", the friction VALID a quarter to a third too large.
TEST(Stribeck, WhatRowsDoNotSeeOfAShortRecordRunsDo) {
  for (const uint64_t seed : {21, 22, 23}) {
    const diagnosis::Diagnosis d = diagnosis::diagnose(open_rig(), {record({3, 0.05}, seed, 3000, 1e-4)}, {});
    ASSERT_EQ(d.causes.size(), 1u) << seed << ": " << said(d);
    EXPECT_EQ(d.causes[0].effect, "stribeck") << seed << ": " << said(d);
    EXPECT_NEAR(value_of(d.extended, "coulomb[1-0]"), kCoulomb_N, 0.3) << seed;
    EXPECT_NEAR(value_of(d.extended, "viscous[1-0]"), kViscous_N_s_m, 0.08 * kViscous_N_s_m) << seed;
  }
}

}  // namespace
