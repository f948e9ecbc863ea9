// A damper pulled to and fro by a drive, between a load cell and the ground; the carriage between the two has a mass. Closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "two_masses.hpp"

namespace {

using namespace two_masses;
using host_sim::Quantity;

constexpr double kMass_kg = 25, kViscous_N_s_m = 40, kCoulomb_N = 18;

host_sim::Record record() {
  constexpr double kAmplitude_m[] = {0.012, 0.006, 0.002}, kOmega[] = {7.0, 17.3, 41.9};
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  std::vector<double> force, place, speed;
  for (int k = 0; k < 8000; ++k) {
    const double t = k / 1000.0;
    double x = 0, v = 0, a = 0;
    for (int i = 0; i < 3; ++i) {
      const double size = kAmplitude_m[i], w = kOmega[i], phase = w * t + i;
      x += size * std::sin(phase), v += size * w * std::cos(phase), a -= size * w * w * std::sin(phase);
    }
    force.push_back(kMass_kg * a + kViscous_N_s_m * v + std::copysign(kCoulomb_N, v) + 0.5 * normal(random));
    place.push_back(x + 1e-6 * normal(random)), speed.push_back(v + 1e-4 * normal(random));
  }
  host_sim::Record made;
  made.file = "tester.csv", made.sample_period_s = 1e-3;
  made.channels = {{"force_1_N", Quantity::kForce, 1, force},
                   {"displacement_1_m", Quantity::kDisplacement, 1, place},
                   {"velocity_1_m_s", Quantity::kVelocity, 1, speed}};
  return made;
}

diagnosis::Diagnosis answer_to(double mass_kg) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].mass_kg.value = mass_kg;
  rig.links[0].a = 1;
  rig.links[0].viscous_N_s_m.estimate = rig.links[0].coulomb_N.estimate = true;
  return diagnosis::diagnose(rig, {record()}, {});
}

bool among(const diagnosis::Diagnosis& d, const std::string& effect) {
  const auto is = [&](const auto& place) { return place.effect == effect; };
  return std::any_of(d.causes.begin(), d.causes.end(), is) ||
         std::any_of(d.ambiguous_with.begin(), d.ambiguous_with.end(), is);
}

// The force against an imposed motion has the carriage's in it: without any mass in the rig file that was a damper that drifts.
TEST(ImposedMotion, AMassThatTheRigFileLacksIsNamed) {
  const diagnosis::Diagnosis d = answer_to(0);
  ASSERT_EQ(d.causes.size(), 1u) << said(d);
  EXPECT_EQ(d.causes[0].effect, "mass_error") << said(d);
  EXPECT_NEAR(value_of(d.extended, "mass_error[1]"), kMass_kg, 0.02 * kMass_kg);
  EXPECT_NEAR(value_of(d.extended, "viscous[1-0]"), kViscous_N_s_m, 0.05 * kViscous_N_s_m);
  EXPECT_NEAR(value_of(d.extended, "coulomb[1-0]"), kCoulomb_N, 0.05 * kCoulomb_N);
}

// A damper between a load cell and a moving base: what moves it is the difference, 50 N s/m of it. The base was taken for the ground.
TEST(ImposedMotion, AgainstAMovingBase) {
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  std::vector<double> force, place, speed, base, base_speed;
  for (int k = 0; k < 8000; ++k) {
    const double t = k / 1000.0, v = 0.09 * std::cos(9.0 * t), v_base = 0.13 * std::cos(13.0 * t + 1);
    place.push_back(0.01 * std::sin(9.0 * t) + 1e-6 * normal(random)), speed.push_back(v + 1e-4 * normal(random));
    base.push_back(0.01 * std::sin(13.0 * t + 1) + 1e-6 * normal(random));
    base_speed.push_back(v_base + 1e-4 * normal(random));
    force.push_back(50 * (v - v_base) + 0.02 * normal(random));
  }
  host_sim::Record made;
  made.file = "tester.csv", made.sample_period_s = 1e-3;
  made.channels = {{"force_1_N", Quantity::kForce, 1, force},
                   {"displacement_1_m", Quantity::kDisplacement, 1, place},
                   {"velocity_1_m_s", Quantity::kVelocity, 1, speed},
                   {"displacement_base_m", Quantity::kDisplacement, rig_file::kBase, base},
                   {"velocity_base_m_s", Quantity::kVelocity, rig_file::kBase, base_speed}};
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.links[0].a = 1, rig.links[0].b = rig_file::kBase;
  rig.links[0].viscous_N_s_m.estimate = true;
  const diagnosis::Diagnosis d = diagnosis::diagnose(rig, {made}, {});
  EXPECT_EQ(diagnosis::verdict_word(d.verdict), std::string("none")) << said(d);
  EXPECT_NEAR(value_of(d.baseline, "viscous[1-base]"), 50, 0.5);
}

// A fiftieth of the mass, or a load cell that reads fifty times too much: where the mass is all that is known they are the same,
// r = 25 / 0.5. A dead band that the force never leaves was a third name for it.
TEST(ImposedMotion, AWrongMassAndAWrongGainAreOneAnotherWhereNothingElseIsKnown) {
  const diagnosis::Diagnosis d = answer_to(0.5);
  EXPECT_TRUE(among(d, "mass_error")) << said(d);
  EXPECT_TRUE(among(d, "sensor_gain")) << said(d);
  EXPECT_FALSE(among(d, "drive_dead_band")) << said(d);
}

// A weight of 150 N hangs on the load cell and dry friction of 4 N bends over 4 mm before it slides: dz = (s - z) |dx| / 4 mm. Beside the
// weight, a thousand times the square of all that moves, no further cause was asked for.
TEST(ImposedMotion, BesideALargeConstantForceFrictionIsStillNamed) {
  host_sim::Record bristles = record();
  std::vector<double>& force = bristles.channels[0].values;
  const std::vector<double>& speed = bristles.channels[2].values;
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  double z = 1;
  for (size_t k = 0; k < force.size(); ++k) {
    const double sign = speed[k] < 0 ? -1 : 1;
    z = sign + (z - sign) * std::exp(-std::abs(speed[k]) * 1e-3 / 0.004);
    force[k] = 150 + 10 * speed[k] + 4 * z + 0.05 * normal(random);
  }
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.links[0].a = 1;
  rig.links[0].viscous_N_s_m.estimate = rig.links[0].coulomb_N.estimate = true;
  const diagnosis::Diagnosis d = diagnosis::diagnose(rig, {bristles}, {});
  EXPECT_TRUE(among(d, "force_offset")) << said(d);
  EXPECT_TRUE(among(d, "presliding_hysteresis")) << said(d);
  EXPECT_NEAR(value_of(d.extended, "force_offset[1-0]"), 150, 0.5);
  EXPECT_NEAR(value_of(d.extended, "viscous[1-0]"), 10, 1);
}

}  // namespace
