// Free decays that begin with something that the rig file has not.
#include "host_sim/diagnosis/later_start.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host_sim/records/stretch.hpp"
#include "tests/hidden_rig/draw.hpp"
#include "two_masses.hpp"

namespace {

using namespace diagnosis;
using host_sim::Quantity;

constexpr double kMass_kg = 1, kStiffness_N_m = 40, kViscous_N_s_m = 0.3;  // 1.007 Hz, a time constant of 6.7 s

// 40 s at 50 Hz of a displacement. Until `held_s` a hand moves the mass, 20 mm at 0.37 and 10 mm at 0.83 Hz, and lets go where it is then;
// x = e^(-a t) (x0 cos w t + (a x0 + v0) / w sin w t) from there, a = c / 2 m. Noise of 0.1 mm.
host_sim::Record handled(double held_s, unsigned seed) {
  const auto hand = [](double t) { return 0.02 * std::sin(2.3248 * t) + 0.01 * std::sin(5.215 * t + 1); };
  const double x0 = hand(held_s),
               v0 = 0.02 * 2.3248 * std::cos(2.3248 * held_s) + 0.01 * 5.215 * std::cos(5.215 * held_s + 1);
  const double a = kViscous_N_s_m / (2 * kMass_kg), omega = std::sqrt(kStiffness_N_m / kMass_kg - a * a);
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 1e-4);
  std::vector<double> x;
  for (int k = 0; k < 2000; ++k) {
    const double t = k / 50.0, gone = t - held_s;
    x.push_back((gone < 0 ? hand(t)
                          : std::exp(-a * gone) *
                                (x0 * std::cos(omega * gone) + (a * x0 + v0) / omega * std::sin(omega * gone))) +
                noise(random));
  }
  host_sim::Record record;
  record.sample_period_s = 1 / 50.0;
  record.channels = {{"displacement_1_m", Quantity::kDisplacement, 1, x}};
  return record;
}

rig_file::RigModel one_mass() {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].mass_kg.value = kMass_kg;
  rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
  rig.links[0].stiffness_N_m.estimate = rig.links[0].viscous_N_s_m.estimate = true;
  return rig;
}

TEST(LaterStart, ADecayThatBeginsInAHandIsToldFromWhereItIsFree) {
  const Diagnosis d = diagnose(one_mass(), {handled(9, 3)}, {}, {});
  EXPECT_EQ(d.verdict, Verdict::kNone);
  EXPECT_EQ(d.cannot_describe, "");
  ASSERT_EQ(d.told_from_s.size(), 1u);
  EXPECT_GE(d.told_from_s[0], 9);
  EXPECT_LE(d.told_from_s[0], 20);
  const Parameter stiffness = two_masses::parameter_of(d.baseline, "stiffness[1-0]"),
                  viscous = two_masses::parameter_of(d.baseline, "viscous[1-0]");
  EXPECT_NEAR(stiffness.value, kStiffness_N_m, 4 * stiffness.std);
  EXPECT_NEAR(viscous.value, kViscous_N_s_m, 4 * viscous.std);
  EXPECT_LT(viscous.std, 0.02 * kViscous_N_s_m);
}

TEST(LaterStart, ADecayThatIsFreeFromItsStartIsToldWhole) {
  const Diagnosis d = diagnose(one_mass(), {handled(0, 4)}, {}, {});
  EXPECT_EQ(d.verdict, Verdict::kNone);
  EXPECT_TRUE(d.told_from_s.empty());
}

// Half of 150 samples are too few to say anything of: what is said of all stands, and nothing is thrown.
TEST(LaterStart, IsNotSoughtWhereTooLittleWouldBeLeft) {
  host_sim::Record record = handled(9, 6);
  record.channels[0].values.resize(150);  // 3 s, all in the hand
  Diagnosis d;
  EXPECT_NO_THROW(d = diagnose(one_mass(), {record}, {}, {}));
  EXPECT_NE(d.verdict, Verdict::kNone);
}

// Of a record that `check` cut one second too early: 0.94 s of the hand are left, and a bent spring would do.
TEST(LaterStart, MoreOfTheHandThanWasCutOffIsLeftOut) {
  const host_sim::Record cut = host_sim::stretch_of(handled(9, 3), 403, 2000);  // from 8.06 s
  const Diagnosis d = diagnose(one_mass(), {cut}, {}, {});
  EXPECT_EQ(two_masses::said(d), "none");
  ASSERT_EQ(d.told_from_s.size(), 1u);
  EXPECT_GE(d.told_from_s[0], 9);
  const Parameter viscous = two_masses::parameter_of(d.baseline, "viscous[1-0]");
  EXPECT_NEAR(viscous.value, kViscous_N_s_m, 4 * viscous.std);
}

double missed_percent = 0;  // by what is judged from a later start

Diagnosis judge_by_its_start(const Asked& asked) {
  Diagnosis d;
  d.verdict = Verdict::kNone;
  if (asked.training[0].start_s < 9)  // the hand's
    d.verdict = Verdict::kUnknown, d.cannot_describe = "nothing is followed";
  else
    d.extended.holdout_nrmse_percent = {missed_percent};
  return d;
}

// 40 N/m of which the root of the elongation takes up to a tenth, from 20 mm on; 50 Hz, noise of 0.1 mm. By steps of a millisecond.
host_sim::Record softened(unsigned seed) {
  const auto pull = [](double x, double v) {
    return -kStiffness_N_m * x * (1 - 0.1 * std::sqrt(std::abs(x) / 0.02)) - kViscous_N_s_m * v;
  };
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 1e-4);
  host_sim::Record record = handled(0, seed);
  double x = 0.02, v = 0;
  for (double& reading : record.channels[0].values) {
    reading = x + noise(random);
    for (int i = 0; i < 20; ++i) {
      const double h = 0.001, half_v = v + h / 2 * pull(x, v);
      x += h * half_v;
      v = half_v + h / 2 * pull(x, half_v);
    }
  }
  return record;
}

// A law that larger motion shows is no hand: the less of it is left the better noise hides it, and numbers that were VALID from 8 s on moved
// on with a later start.
TEST(LaterStart, IsNoneOfALawThatLargerMotionShows) {
  const host_sim::Record cut = host_sim::stretch_of(softened(1), 50, 2000);
  const Diagnosis d = diagnose(one_mass(), {cut}, {}, {});
  EXPECT_TRUE(d.told_from_s.empty());
  EXPECT_NE(d.verdict, Verdict::kNone);
  EXPECT_NE(d.verdict, Verdict::kExplained);
}

// A coasting shaft with drag had been "none" from 5 s on, beside 367 % missed.
TEST(LaterStart, IsNoneWhereAllOfWhatFollowsIsMissed) {
  const rig_file::RigModel rig = one_mass();
  const std::vector<host_sim::Record> training{handled(9, 3)}, holdout;
  const Options options;
  const Asked asked{rig, training, holdout, options};
  missed_percent = 72;
  EXPECT_EQ(judged_from_a_later_start(asked, judge_by_its_start).told_from_s.size(), 1u);
  missed_percent = 367;
  const Diagnosis d = judged_from_a_later_start(asked, judge_by_its_start);
  EXPECT_TRUE(d.told_from_s.empty());
  EXPECT_EQ(d.cannot_describe, "nothing is followed");
}

// What coasts slows down all the time: its last part is as simple as it is short.
TEST(LaterStart, IsNoneOfWhatNoSpringHolds) {
  rig_file::RigModel rig = one_mass();
  rig.links[0].stiffness_N_m.estimate = false;
  const std::vector<host_sim::Record> training{handled(9, 3)}, holdout;
  const Options options;
  missed_percent = 1;
  EXPECT_TRUE(judged_from_a_later_start({rig, training, holdout, options}, judge_by_its_start).told_from_s.empty());
}

// A force channel of noughts drives nothing.
TEST(LaterStart, IsSoughtBesideAForceThatNeverActs) {
  host_sim::Record record = handled(9, 3);
  record.channels.push_back({"force_1_N", Quantity::kForce, 1, std::vector<double>(record.samples(), 0.0)});
  EXPECT_EQ(diagnose(one_mass(), {record}, {}, {}).told_from_s.size(), 1u);
}

// What a force drives has no start of its own: where nothing is described, that is the answer.
TEST(LaterStart, IsNotSoughtWhereAForceIsMeasured) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise;
  host_sim::Record record = handled(40, 5);
  record.channels.push_back({"force_1_N", Quantity::kForce, 1, {}});
  for (size_t k = 0; k < record.samples(); ++k) record.channels[1].values.push_back(noise(random));
  const Diagnosis d = diagnose(one_mass(), {record}, {}, {});
  EXPECT_TRUE(d.told_from_s.empty());
  EXPECT_NE(d.verdict, Verdict::kNone);
}

// Eight numbers, of which one moves by 2.8 deviations from the whole of the motion to its later half: of so many chance moves one beyond its
// 95 % interval in one record of three. A damper to the ground that the rig file lacks was found, and not said.
TEST(LaterStart, OfManyNumbersOneMayMoveByChance) {
  hidden_rig::Settings settings;
  settings.condition = "free_decay_to_rest", settings.sensors = "xva", settings.hidden = "missing_viscous";
  const hidden_rig::Draw draw = hidden_rig::make_draw(33400013, settings);
  const diagnosis::Diagnosis d = diagnosis::diagnose(draw.rig, draw.records, {});
  EXPECT_TRUE(d.names("missing_viscous", draw.hidden[0].where)) << two_masses::said(d);
}

}  // namespace
