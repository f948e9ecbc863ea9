// Two inertias on a shaft that turn freely together, angles from encoders: what the shaft does is a hundredth of the motion.
// The plant here is its own: fourth-order Runge-Kutta, dry friction as a steep smooth law.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "two_masses.hpp"

namespace {

using namespace two_masses;

constexpr double kTwoPi = 6.283185307179586;
constexpr double kRate_Hz = 1000;
constexpr int kFiner = 10;

struct Train {
  double inertia[2] = {2.1e-3, 3.4e-3};
  double stiffness = 58, shaft_viscous = 0.018;
  double motor_viscous = 0.007, motor_coulomb = 0.11, load_coulomb = 0.08;
  double reversal_rad_s = 0.02;  // within which dry friction turns over
  double gap_rad = 0, cubic = 0;
  double torque_rms = 1.2, duration_s = 16, step_rad = kTwoPi / 8192, torque_noise = 0.006;
  std::vector<double> lines_Hz;  // of the torque; empty: eighty anywhere from 0.5 to 30 Hz
  uint64_t seed = 1;
};

State slope_of(const Train& t, const State& s, double torque) {
  const double twist = s.x[0] - s.x[1], rate = s.v[0] - s.v[1];
  const double beyond = twist > t.gap_rad ? twist - t.gap_rad : twist < -t.gap_rad ? twist + t.gap_rad : 0;
  const double shaft = t.stiffness * beyond + t.shaft_viscous * rate + t.cubic * twist * twist * twist;
  State out;
  out.x[0] = s.v[0], out.x[1] = s.v[1];
  out.v[0] = (torque - shaft - t.motor_viscous * s.v[0] - t.motor_coulomb * std::tanh(s.v[0] / t.reversal_rad_s)) /
             t.inertia[0];
  out.v[1] = (shaft - t.load_coulomb * std::tanh(s.v[1] / t.reversal_rad_s)) / t.inertia[1];
  return out;
}

host_sim::Record record_of(const Train& t) {
  std::mt19937_64 random(t.seed);
  std::uniform_real_distribution<double> phase(0, kTwoPi), hertz(0.5, 30);
  std::vector<double> omega, start;
  const int lines = t.lines_Hz.empty() ? 80 : static_cast<int>(t.lines_Hz.size());
  for (int i = 0; i < lines; ++i) {
    omega.push_back(kTwoPi * (t.lines_Hz.empty() ? hertz(random) : t.lines_Hz[static_cast<size_t>(i)]));
    start.push_back(phase(random));
  }
  const auto torque = [&](double at) {
    double sum = 0;
    for (size_t i = 0; i < omega.size(); ++i) sum += std::sin(omega[i] * at + start[i]);
    return t.torque_rms * std::sqrt(2.0 / static_cast<double>(omega.size())) * sum;
  };
  std::normal_distribution<double> normal;
  const int samples = static_cast<int>(kRate_Hz * t.duration_s);
  const double h = 1 / (kRate_Hz * kFiner);
  std::vector<double> values[3];
  State s;
  for (int k = 0; k < samples; ++k) {
    double now = torque(k / kRate_Hz);
    values[0].push_back(now + t.torque_noise * normal(random));
    for (int i = 0; i < 2; ++i) values[i + 1].push_back(t.step_rad * std::round(s.x[i] / t.step_rad));
    for (int i = 0; i < kFiner; ++i) {
      const double at = k / kRate_Hz + i * h, middle = torque(at + h / 2), next = torque(at + h);
      s = stepped(s, h, now, middle, next,
                  [&](const State& at_state, double torque_now) { return slope_of(t, at_state, torque_now); });
      now = next;
    }
  }
  host_sim::Record record;
  record.file = "train.csv", record.sample_period_s = 1 / kRate_Hz;
  record.channels = {{"torque_1_N_m", host_sim::Quantity::kForce, 1, values[0]},
                     {"angle_1_rad", host_sim::Quantity::kDisplacement, 1, values[1]},
                     {"angle_2_rad", host_sim::Quantity::kDisplacement, 2, values[2]}};
  return record;
}

diagnosis::Diagnosis answer_to(const Train& t) {
  rig_file::RigModel rig;
  for (double inertia : t.inertia) {
    rig.dofs.emplace_back();
    rig.dofs.back().mass_kg.value = inertia, rig.dofs.back().rotating = true;
  }
  rig.links.resize(3);
  rig.links[0].a = 1, rig.links[0].b = 0;
  rig.links[0].viscous_N_s_m.estimate = rig.links[0].coulomb_N.estimate = true;
  rig.links[1].a = 2, rig.links[1].b = 0;
  rig.links[1].coulomb_N.estimate = true;
  rig.links[2].a = 1, rig.links[2].b = 2;
  rig.links[2].stiffness_N_m.value = t.stiffness, rig.links[2].viscous_N_s_m.estimate = true;
  return diagnosis::diagnose(rig, {record_of(t)}, {});
}

TEST(DriveTrain, ARightRigIsRight) {
  const Train t;
  const diagnosis::Diagnosis d = answer_to(t);
  EXPECT_EQ(said(d), "none");
  EXPECT_NEAR(value_of(d.baseline, "viscous[1-2]"), t.shaft_viscous, 0.05 * t.shaft_viscous);
  EXPECT_NEAR(value_of(d.baseline, "coulomb[2-0]"), t.load_coulomb, 0.05 * t.load_coulomb);
}

// The shaft swings at 82 Hz by 10^-4 of the angles: thinned out to what those need, half a minute of it holds three samples a swing, and the
// two frictions were traded (0.134 and 0.066 for 0.08 and 0.12, VALID).
TEST(DriveTrain, AStiffShaftIsNotThinnedAway) {
  Train t;
  t.inertia[1] = 6.5e-3, t.stiffness = 420, t.shaft_viscous = 0.02, t.motor_coulomb = 0.12;
  t.lines_Hz = {0.5, 1.1, 2.3, 4.1, 7.7, 13.1, 21.3, 33.7, 47.9, 61.3}, t.torque_rms = 0.72, t.duration_s = 30,
  t.step_rad = kTwoPi / 1048576, t.torque_noise = 0.001, t.reversal_rad_s = 0.003;
  const diagnosis::Diagnosis d = answer_to(t);
  EXPECT_EQ(said(d), "none");
  EXPECT_NEAR(value_of(d.baseline, "viscous[1-2]"), t.shaft_viscous, 0.1 * t.shaft_viscous);
  EXPECT_NEAR(value_of(d.baseline, "coulomb[1-0]"), t.motor_coulomb, 0.02 * t.motor_coulomb);
  EXPECT_NEAR(value_of(d.baseline, "coulomb[2-0]"), t.load_coulomb, 0.02 * t.load_coulomb);
}

TEST(DriveTrain, AGapInTheShaftIsNamed) {
  Train t;
  t.gap_rad = 0.008, t.seed = 2;
  const diagnosis::Diagnosis d = answer_to(t);
  ASSERT_EQ(d.causes.size(), 1u) << said(d);
  EXPECT_EQ(d.causes[0].effect + " on " + d.causes[0].where, "backlash on link 1-2");
  EXPECT_NEAR(value_of(d.extended, "backlash_gap[1-2]"), t.gap_rad, 0.05 * t.gap_rad);
  EXPECT_NEAR(value_of(d.extended, "viscous[1-0]"), t.motor_viscous, 0.1 * t.motor_viscous);
}

// Beside it a weak end stop of nearly the same force may be named: what the extended shaft holds at its largest twist is right.
TEST(DriveTrain, AStiffeningShaftIsNamed) {
  Train t;
  t.cubic = 1.5e5, t.seed = 3;
  const diagnosis::Diagnosis d = answer_to(t);
  double largest = 0, held = 0;
  const host_sim::Record record = record_of(t);
  for (size_t k = 0; k < record.samples(); ++k)
    largest = std::max(largest, std::abs(record.channels[1].values[k] - record.channels[2].values[k]));
  bool cubic = false;
  for (const diagnosis::Cause& c : d.causes) {
    EXPECT_EQ(c.where, "link 1-2") << said(d);
    if (c.effect == "cubic_stiffness") {
      cubic = true, held += c.parameters[0].value * largest * largest * largest;
    } else {
      ASSERT_EQ(c.effect, "end_stop") << said(d);
      held += c.parameters[0].value * std::max(0.0, largest - c.parameters[1].value);
    }
  }
  EXPECT_TRUE(cubic) << said(d);
  EXPECT_NEAR(held, t.cubic * largest * largest * largest, 0.05 * t.cubic * largest * largest * largest) << said(d);
}

}  // namespace
