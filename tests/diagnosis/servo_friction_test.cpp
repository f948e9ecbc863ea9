// A servo motor without a spring whose dry friction stops it at every reversal, read by an encoder. A window of it that begins where
// it stands still hardly determines its state. The plant here is its own: friction holds exactly.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "two_masses.hpp"

namespace {

using namespace two_masses;

constexpr double kTwoPi = 6.283185307179586;
constexpr double kRate_Hz = 1000, kDuration_s = 20, kStep_rad = kTwoPi / 10000;
constexpr int kFiner = 20;

struct Servo {
  double inertia = 8.7e-3, viscous = 0.045, coulomb = 0.96;
  double stribeck = 0, stribeck_velocity = 0.5;
  double torque = 2, hertz = 0.5;
  uint64_t seed = 1;
};

// Over h the torque is constant; what friction can hold stays where it is.
void step(const Servo& s, double torque, double h, double& angle, double& rate) {
  const double friction = s.coulomb + s.stribeck * std::exp(-std::abs(rate) / s.stribeck_velocity);
  const double free_rate = rate + h * (torque - s.viscous * rate) / s.inertia, most = h * friction / s.inertia;
  const double next = std::abs(free_rate) <= most ? 0 : free_rate - std::copysign(most, free_rate);
  angle += h * 0.5 * (rate + next), rate = next;
}

host_sim::Record record_of(const Servo& s) {
  std::mt19937_64 random(s.seed);
  std::normal_distribution<double> normal;
  const auto torque = [&](double t) {
    return s.torque * (std::sin(kTwoPi * s.hertz * t) + 0.5 * std::sin(kTwoPi * 2.7 * s.hertz * t));
  };
  const double h = 1 / (kRate_Hz * kFiner);
  std::vector<double> torques, angles;
  double angle = 0, rate = 0;
  for (int k = 0; k < static_cast<int>(kRate_Hz * kDuration_s); ++k) {
    torques.push_back(torque(k / kRate_Hz) + 0.015 * normal(random));
    angles.push_back(kStep_rad * std::round(angle / kStep_rad));
    for (int i = 0; i < kFiner; ++i) step(s, torque(k / kRate_Hz + (i + 0.5) * h), h, angle, rate);
  }
  host_sim::Record record;
  record.file = "servo.csv", record.sample_period_s = 1 / kRate_Hz;
  record.channels = {{"torque_1_N_m", host_sim::Quantity::kForce, 1, torques},
                     {"angle_1_rad", host_sim::Quantity::kDisplacement, 1, angles}};
  return record;
}

diagnosis::Diagnosis answer_to(const Servo& s) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].rotating = true, rig.dofs[0].mass_kg.estimate = true;
  rig.links[0].a = 1, rig.links[0].b = 0;
  rig.links[0].viscous_N_s_m.estimate = rig.links[0].coulomb_N.estimate = true;
  return diagnosis::diagnose(rig, {record_of(s)}, {});
}

// Torque of 2 and 1 N m against friction of 0.96 N m: it turns by 10 rad and stands still a sixth of the time.
TEST(ServoFriction, AFileThatSaysItAllLacksNothing) {
  for (const double hertz : {0.45, 0.62}) {
    Servo s;
    s.hertz = hertz, s.seed = static_cast<uint64_t>(1000 * hertz);
    const diagnosis::Diagnosis d = answer_to(s);
    EXPECT_EQ(said(d), "none") << hertz << " Hz";
    EXPECT_NEAR(value_of(d.baseline, "mass[1]"), s.inertia, 0.01 * s.inertia) << hertz << " Hz";
    EXPECT_NEAR(value_of(d.baseline, "viscous[1-0]"), s.viscous, 0.02 * s.viscous) << hertz << " Hz";
    EXPECT_NEAR(value_of(d.baseline, "coulomb[1-0]"), s.coulomb, 0.01 * s.coulomb) << hertz << " Hz";
  }
}

// Friction that is 1.6 times as large at rest, and falls within 0.5 rad/s, which the motor passes in a few samples: what breaks it
// loose is determined, 0.96 + 0.6 = 1.56 N m.
TEST(ServoFriction, StribeckFrictionIsNamed) {
  Servo s;
  s.stribeck = 0.6, s.hertz = 0.8;
  const diagnosis::Diagnosis d = answer_to(s);
  ASSERT_EQ(d.causes.size(), 1u) << said(d);
  EXPECT_EQ(d.causes[0].effect + " on " + d.causes[0].where, "stribeck on link 1-0");
  EXPECT_NEAR(value_of(d.extended, "coulomb[1-0]") + value_of(d.extended, "stribeck[1-0]"), 1.56, 0.05 * 1.56);
}

}  // namespace
