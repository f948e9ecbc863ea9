// What stands before a free motion was let go.
#include "host_sim/diagnosis/record/released.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host_sim/diagnosis/diagnosis.hpp"
#include "two_masses.hpp"

namespace {

using namespace diagnosis;
using host_sim::Quantity;

// 1 kg on 4000 N/m (10.07 Hz) with 2 N s/m, let go at 5 mm: 3 s at 1 kHz. While it is held, `held` samples, its accelerometer reads nought,
// and then 20 m/s^2. Noise of 0.02 m/s^2.
host_sim::Record decay(int held, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 0.02);
  const double half = 1.0, omega = std::sqrt(4000 - half * half);
  std::vector<double> y;
  for (int k = 0; k < held; ++k) y.push_back(noise(random));
  for (int k = 0; k < 3000; ++k) {  // x = 5 mm e^(-t) (cos w t + sin(w t) / w)
    const double t = 1e-3 * k,
                 x = 5e-3 * std::exp(-half * t) * (std::cos(omega * t) + half / omega * std::sin(omega * t)),
                 v = -5e-3 * std::exp(-half * t) * 4000 / omega * std::sin(omega * t);
    y.push_back(-4000 * x - 2 * v + noise(random));
  }
  host_sim::Record record;
  record.sample_period_s = 1e-3;
  record.channels = {{"acceleration_1_m_s2", Quantity::kAcceleration, 1, y}};
  return record;
}

TEST(Released, RowsBeforeItAreLeftOut) {
  for (const int held : {1, 7, 40}) {
    const auto rest = from_release({decay(held, 3)});
    EXPECT_EQ(rest[0].samples(), 3000u) << held;
    EXPECT_NEAR(rest[0].channels[0].values[0], -20, 0.1);
    EXPECT_NEAR(rest[0].start_s, 1e-3 * held, 1e-9);
  }
  EXPECT_EQ(from_release({decay(0, 3)})[0].samples(), 3000u);
  EXPECT_TRUE(any_begins_held({decay(0, 3), decay(1, 3)}));
  EXPECT_FALSE(any_begins_held({decay(0, 3), decay(0, 4)}));
}

TEST(Released, WhatAForceDrivesIsKeptWhole) {
  host_sim::Record record = decay(1, 4);
  record.channels.push_back({"force_1_N", Quantity::kForce, 1, std::vector<double>(3001, 0.0)});
  EXPECT_EQ(from_release({record})[0].samples(), 3000u) << "a force that reads nought throughout drives nothing";
  record.channels.back().values[100] = 1.0;
  EXPECT_EQ(from_release({record})[0].samples(), 3001u);
}

// One sample of 20 m/s^2 in a rms of 6: more than all that noise is.
TEST(Released, ARightRigIsRightThoughOneRowIsBeforeIt) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].mass_kg.value = 1;
  rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
  rig.links[0].stiffness_N_m.value = 4000, rig.links[0].viscous_N_s_m.estimate = true;
  const Diagnosis d = diagnose(rig, {decay(1, 5), decay(1, 6), decay(1, 7)}, {}, {});
  EXPECT_EQ(d.verdict, Verdict::kNone);
  const Parameter viscous = two_masses::parameter_of(d.baseline, "viscous[1-0]");
  EXPECT_NEAR(viscous.value, 2, 4 * viscous.std);
  EXPECT_LT(viscous.std, 0.02);
}

}  // namespace
