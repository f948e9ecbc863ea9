// An error that nobody could put right is no finding.
#include "host_sim/diagnosis/doubts/trifles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host_sim/diagnosis/doubts/laws_apart.hpp"

namespace diagnosis::runs {
namespace {

// 2 kg on 5000 N/m: a trifle is less than 0.4 g, 1 N/m, a gain of 0.0002.
struct OneMass {
  System system;
  std::vector<Prepared> records;
  OneMass() {
    rig_file::RigModel rig;
    rig.dofs.resize(1), rig.dofs[0].mass_kg.value = 2;
    rig.links.resize(1), rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
    rig.links[0].stiffness_N_m.value = 5000;
    system = make_system(rig);
  }
  Diagnosis of(const char* effect, const char* where, double value) const {
    Diagnosis d;
    d.verdict = Verdict::kExplained;
    Cause c;
    c.effect = effect, c.where = where, c.parameters = {{effect, value, "", 1e-9, true}};
    d.causes = {c};
    drop_trifles(Task{system, records, 0}, d);
    return d;
  }
};

TEST(Trifles, AreNotNamed) {
  const OneMass rig;
  EXPECT_EQ(rig.of("mass_error", "dof 1", -0.00039).verdict, Verdict::kNone);
  EXPECT_EQ(rig.of("stiffness_error", "link 1-0", 0.99).verdict, Verdict::kNone);
  EXPECT_EQ(rig.of("sensor_gain", "channel displacement_1_m", 0.00019).verdict, Verdict::kNone);
}

// A sine of rms 1 with noise of rms 0.05: 0.25 % of its power, so that a gain counts from 0.5 % on.
TEST(Trifles, AGainWithinWhatNoiseMakesOfItIsNotNamed) {
  OneMass rig;
  Prepared p;
  MotionTrace trace{0, 0, "displacement_1_m", Vec(20000)};
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (Index k = 0; k < trace.y.size(); ++k)
    trace.y[k] = std::sqrt(2.0) * std::sin(0.1 * static_cast<double>(k)) + 0.05 * normal(random);
  p.traces = {trace};
  rig.records = {p};
  EXPECT_EQ(rig.of("sensor_gain", "channel displacement_1_m", -0.0045).verdict, Verdict::kNone);
  EXPECT_EQ(rig.of("sensor_gain", "channel displacement_1_m", -0.0055).causes.size(), 1u);
}

TEST(Trifles, WhatIsMoreStays) {
  const OneMass rig;
  EXPECT_EQ(rig.of("mass_error", "dof 1", -0.00041).causes.size(), 1u);
  EXPECT_EQ(rig.of("stiffness_error", "link 1-0", 1.01).causes.size(), 1u);
  EXPECT_EQ(rig.of("sensor_gain", "channel displacement_1_m", 0.00021).causes.size(), 1u);
  EXPECT_EQ(rig.of("sensor_delay", "channel displacement_1_m", 1e-9).causes.size(), 1u);  // of nothing that is given
}

// What looked like the trifle goes with it; the other cause stays, and is no alternative to itself.
TEST(Trifles, TakeTheirRivalsWithThem) {
  const OneMass rig;
  Diagnosis d = rig.of("mass_error", "dof 1", 1);
  d.verdict = Verdict::kAmbiguous;
  Cause trifle = d.causes[0];
  trifle.parameters[0].value = 1e-6;
  d.causes[0].effect = "sensor_delay", d.causes[0].where = "channel displacement_1_m";
  d.causes.push_back(trifle);
  d.ambiguous_with = {{"unmodelled_resonance", "dof 1"}, {"sensor_delay", "channel displacement_1_m"}};
  drop_trifles(Task{rig.system, rig.records, 0}, d);
  ASSERT_EQ(d.causes.size(), 1u);
  EXPECT_TRUE(d.ambiguous_with.empty());
  EXPECT_EQ(d.verdict, Verdict::kExplained);
}

Cause drag(double value, double std) {
  Cause c;
  c.effect = "quadratic_damping", c.where = "link 1-0";
  c.parameters = {{"quadratic_damping[1-0]", value, "N s^2/m^2", std, true}};
  return c;
}

// 1.96 standard deviations of 1 reach from 1.95 beyond nought, from 1.97 not.
TEST(Undetermined, ACauseWhoseIntervalContainsNoughtIsTakenBack) {
  for (const Verdict verdict : {Verdict::kExplained, Verdict::kPartly, Verdict::kAmbiguous}) {
    Diagnosis d;
    d.verdict = verdict, d.causes = {drag(-1.95, 1)}, d.ambiguous_with = {{"stribeck", "link 1-0"}};
    drop_undetermined(d, true);
    EXPECT_TRUE(d.causes.empty());
    EXPECT_TRUE(d.ambiguous_with.empty());
    EXPECT_EQ(d.verdict, verdict == Verdict::kExplained ? Verdict::kNone : Verdict::kUnknown);
  }
  // what the rig as given does not follow at all lacks something, whatever it is
  for (const bool follows : {true, false}) {
    Diagnosis d;
    d.verdict = Verdict::kExplained, d.causes = {drag(-1.95, 1)}, d.baseline_misfit = 40, d.gain = {0.3};
    drop_undetermined(d, follows);
    EXPECT_EQ(d.verdict, follows ? Verdict::kNone : Verdict::kUnknown);
  }
  Diagnosis d;
  d.verdict = Verdict::kExplained, d.causes = {drag(-1.97, 1), drag(5, 0)};
  drop_undetermined(d, true);
  ASSERT_EQ(d.causes.size(), 1u) << "the second says what the first has said";
  EXPECT_EQ(d.causes[0].parameters[0].value, -1.97);
  EXPECT_EQ(d.verdict, Verdict::kExplained);
}

// One mass whose rate is a square wave of 2 m/s at an elongation of 0.01 m.
Prepared square_wave() {
  Prepared p;
  p.step_s = 0.01, p.samples = 400, p.guess.resize(2);
  p.guess[0] = {true, Vec::Constant(400, 0.01), Vec(400), Vec::Zero(400)};
  for (Index k = 0; k < 400; ++k) p.guess[0].v[k] = (k / 20) % 2 ? 2 : -2;
  return p;
}

Model forces(double mass, double stiffness, double viscous, double coulomb, double quadratic) {
  const std::pair<Term, double> terms[] = {{on_dof(Kind::kMass, 0), mass},
                                           {on_link(Kind::kStiffness, 0), stiffness},
                                           {on_link(Kind::kViscous, 0), viscous},
                                           {on_link(Kind::kCoulomb, 0), coulomb},
                                           {on_link(Kind::kQuadraticDamping, 0), quadratic}};
  Model m;
  for (const auto& [term, value] : terms) {
    ModelTerm t;
    t.term = term, t.value = value;
    m.push_back(t);
  }
  return m;
}

// At 2 m/s: 10 w = 8 w + 4 sgn w = 8 w + w |w|, all 20 N: laws that share a force in another way are no other force.
// 5000 + 100 N/m is 2 % more, 2 + 0.08 kg 4 %, 10 w + 1.5 sgn w is 21.5 N for 20: 7.5 %.
TEST(LawsApart, CountTheForceAndNotItsShares) {
  OneMass rig;
  rig.records = {square_wave()};
  const Task task{rig.system, rig.records, 1};
  const Model plain = forces(2, 5000, 10, 0, 0);
  EXPECT_NEAR(laws_apart(task, plain, forces(2, 5000, 8, 4, 0)), 0, 1e-12);
  EXPECT_NEAR(laws_apart(task, plain, forces(2, 5000, 8, 0, 1)), 0, 1e-12);
  EXPECT_NEAR(laws_apart(task, plain, forces(2, 5100, 10, 0, 0)), 0.02, 1e-9);
  EXPECT_NEAR(laws_apart(task, plain, forces(2.08, 5000, 10, 0, 0)), 0.04, 1e-9);
  EXPECT_NEAR(laws_apart(task, plain, forces(2, 5100, 10, 1.5, 0)), 0.075, 1e-9);
}

}  // namespace
}  // namespace diagnosis::runs
