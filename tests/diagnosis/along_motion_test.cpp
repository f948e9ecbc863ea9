// A joint that something else than its torque turns: what is asked of its forces, and whose answer stands.
#include "host_sim/diagnosis/along_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using diagnosis::Asked;
using diagnosis::Diagnosis;
using diagnosis::Verdict;
using host_sim::Channel;
using host_sim::Quantity;

// 0.2 kg m^2 that swings at 1 Hz by 1 rad, and a constant torque of 5 N m: T = J a + 5, a = -(2 pi)^2 sin(2 pi t).
constexpr double kInertia_kg_m2 = 0.2, kTorque_N_m = 5.0;

std::vector<host_sim::Record> records() {
  Channel torque{"torque_1_N_m", Quantity::kForce, 1, {}, 0.0},
      angle{"angle_1_rad", Quantity::kDisplacement, 1, {}, 0.0},
      acceleration{"angular_acceleration_1_rad_s2", Quantity::kAcceleration, 1, {}, 0.0};
  for (int i = 0; i < 4000; ++i) {
    const double x = std::sin(2 * M_PI * 0.005 * i), a = -4 * M_PI * M_PI * x;
    angle.values.push_back(x), acceleration.values.push_back(a),
        torque.values.push_back(kInertia_kg_m2 * a + kTorque_N_m);
  }
  host_sim::Record record;
  record.file = "joint.csv", record.sample_period_s = 0.005, record.channels = {torque, angle, acceleration};
  return {record};
}

rig_file::RigModel joint(bool inertia_known) {
  rig_file::RigModel rig;
  rig_file::Dof dof;
  dof.rotating = true, dof.mass_kg = {inertia_known ? kInertia_kg_m2 : 0.0, !inertia_known};
  rig_file::Link link;
  link.a = 1, link.b = rig_file::kGround, link.viscous_N_s_m = {0, true}, link.coulomb_N = {0, true};
  rig.dofs = {dof}, rig.links = {link};
  return rig;
}

Diagnosis answer(const Asked& asked, Verdict verdict, double missed_percent) {
  Diagnosis d;
  d.verdict = verdict, d.extended_rig = asked.rig, d.extended.holdout_nrmse_percent = {missed_percent};
  return d;
}

diagnosis::Cause cause(const char* effect, const char* where, double value) {
  diagnosis::Cause c;
  c.effect = effect, c.where = where, c.parameters = {{std::string(effect) + "[1]", value, "1", 0.01 * value}};
  return c;
}

// What was asked, one after the other; told by what is asked, as a judge is a plain function.
struct Question {
  double mass_kg = 0, least_N_m = 0, most_N_m = 0;
  bool fits_a_mass = false;
};
std::vector<Question> questions;
double missed_along_percent = 3, missed_free_percent = 80;

// Whether a question's rig has a mass to be fitted with the forces.
bool fits_a_mass(const Asked& asked) {
  const auto& effects = asked.rig.dofs[0].effects;
  return effects.size() == 1 && effects[0].kind == "mass_error" && effects[0].coefficient.estimate;
}

Diagnosis free_runs_say;
bool names_a_cause = true;

// What free runs say comes first. Of the forces it says that a constant torque is missing, beside a mass where that is fitted.
Diagnosis judge(const Asked& asked) {
  const std::vector<double>& torque = asked.training[0].find(Quantity::kForce, 1)->values;
  // the ends aside, where a smoothed acceleration has one side alone
  const auto [least, most] = std::minmax_element(torque.begin() + 100, torque.end() - 100);
  questions.push_back({asked.rig.dofs[0].mass_kg.value, *least, *most, fits_a_mass(asked)});
  if (questions.size() == 1) return free_runs_say;
  Diagnosis d = answer(asked, names_a_cause ? Verdict::kExplained : Verdict::kUnknown, missed_along_percent);
  if (names_a_cause) d.causes = {cause("force_offset", "link 1-0", kTorque_N_m)};
  d.extended.parameters = {{"viscous[1-0]", 0.1, "N m s/rad", 0.01}};
  if (fits_a_mass(asked)) d.extended.parameters.push_back({"mass_error[1]", kInertia_kg_m2, "kg m^2", 0.002});
  return d;
}

Diagnosis told(const rig_file::RigModel& rig, double missed_percent = 3) {
  questions.clear(), missed_along_percent = missed_percent;
  const std::vector<host_sim::Record> training = records(), holdout;
  const diagnosis::Options options;
  free_runs_say = answer({rig, training, holdout, options}, Verdict::kUnknown, missed_free_percent);
  return diagnosis::judged_along_the_motion({rig, training, holdout, options}, judge);
}

TEST(AlongMotion, AKnownInertiaIsTakenOffTheTorque) {
  const Diagnosis d = told(joint(true));
  ASSERT_EQ(questions.size(), 2u);
  EXPECT_EQ(questions[1].mass_kg, 0);
  EXPECT_NEAR(questions[1].least_N_m, kTorque_N_m, 0.05);  // of 0.2 x 39.5 = 7.9 N m that the inertia took
  EXPECT_NEAR(questions[1].most_N_m, kTorque_N_m, 0.05);
  EXPECT_TRUE(d.along_motion);
  EXPECT_EQ(d.verdict, Verdict::kExplained);
  EXPECT_EQ(d.extended_rig.dofs[0].mass_kg.value, kInertia_kg_m2);  // the rig file's own again
}

// The torque is as it was measured, 5 +- 7.9 N m, and the inertia one of the numbers that are fitted to it: it is no cause.
TEST(AlongMotion, AnInertiaThatIsAskedForIsFittedWithTheForces) {
  const Diagnosis d = told(joint(false));
  ASSERT_EQ(questions.size(), 2u);
  EXPECT_TRUE(questions[1].fits_a_mass);
  EXPECT_NEAR(questions[1].most_N_m, 12.9, 0.05);
  ASSERT_EQ(d.causes.size(), 1u);
  ASSERT_EQ(d.extended.parameters.size(), 2u);
  EXPECT_EQ(d.extended.parameters[0].name, "mass[1]");
  EXPECT_NEAR(d.extended.parameters[0].value, kInertia_kg_m2, 1e-12);
  EXPECT_TRUE(d.extended.parameters[0].may_be_bent);
  EXPECT_EQ(d.extended.parameters[1].name, "viscous[1-0]");
  EXPECT_TRUE(d.extended_rig.dofs[0].mass_kg.estimate);
  EXPECT_TRUE(d.extended_rig.dofs[0].effects.empty());
}

TEST(AlongMotion, WhatMissesAsMuchOfTheForceSaysNothing) {
  const Diagnosis d = told(joint(true), 60);
  EXPECT_EQ(questions.size(), 2u);
  EXPECT_FALSE(d.along_motion);
  EXPECT_EQ(d.verdict, Verdict::kUnknown);
}

// A spring pulls a simulation back, and without a measured torque there is nothing to compare with.
TEST(AlongMotion, WhatASpringHoldsIsAskedOnce) {
  rig_file::RigModel rig = joint(true);
  rig.links[0].stiffness_N_m = {10, false};
  EXPECT_FALSE(told(rig).along_motion);
  EXPECT_EQ(questions.size(), 1u);
}

// Gravity holds what hangs, and what stands on it falls in a simulation: one that misses more than what swings against the motion has run away.
TEST(AlongMotion, WhatGravityDoesNotHoldIsAskedOfItsForces) {
  rig_file::RigModel arm = joint(true);
  arm.links[0].gravity_torque_N_m = {0, true};
  EXPECT_FALSE(told(arm).along_motion);  // 80 %
  EXPECT_EQ(questions.size(), 1u);
  missed_free_percent = 480;
  EXPECT_TRUE(told(arm).along_motion);
  arm.links[0].stiffness_N_m = {10, false};
  EXPECT_FALSE(told(arm).along_motion);
  missed_free_percent = 80;
}

// Free runs that name nothing know less than forces that are followed but for 3 %, though something is missing in them too.
TEST(AlongMotion, ForcesThatAreFollowedAreToldThoughSomethingIsMissing) {
  names_a_cause = false;
  const Diagnosis d = told(joint(true));
  EXPECT_TRUE(d.along_motion);
  EXPECT_EQ(d.verdict, Verdict::kUnknown);
  EXPECT_FALSE(told(joint(true), 60).along_motion);
  names_a_cause = true;
}

}  // namespace
