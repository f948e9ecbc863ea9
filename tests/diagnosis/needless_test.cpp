// Which of two causes is dropped where one of them does.
#include "host_sim/diagnosis/doubts/needless.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host_sim/diagnosis/doubts/shown.hpp"
#include "host_sim/diagnosis/trial/attempt.hpp"

namespace {

using namespace diagnosis;
using namespace diagnosis::runs;

constexpr double kRate_Hz = 100, kDuration_s = 40, kPitch_rad = 1.2;

// A wheel of 1 kg m^2 on a spring of 100 N m/rad that softens to one side by 20 N m/rad^2, beside a sine of 0.4 N m that repeats after 1.2 rad,
// let go from 1 rad; its encoder has steps of 2 mrad.
host_sim::Record decay() {
  host_sim::Record made;
  made.file = "decay.csv", made.sample_period_s = 1 / kRate_Hz;
  made.channels = {{"angle_1_rad", host_sim::Quantity::kDisplacement, 1, {}}};
  constexpr int kFiner = 50;
  const double h = 1 / (kRate_Hz * kFiner);
  double u = 1, w = 0;
  for (int i = 0; i < kFiner * static_cast<int>(kRate_Hz * kDuration_s); ++i) {
    if (i % kFiner == 0) made.channels[0].values.push_back(0.002 * std::round(u / 0.002));
    u += 0.5 * h * w;
    w += h * (-100 * u + 20 * u * u - 0.4 * std::sin(kTwoPi / kPitch_rad * u) - 0.3 * w);
    u += 0.5 * h * w;
  }
  return made;
}

Named named(const Term& term) {
  Named n;
  n.candidate.terms = {term};
  return n;
}

// Without the spring the sine grows into its place: along 2 rad one of any longer pitch bends alike, and a decay whose start outweighs
// all that follows does not say which is better.
TEST(Needless, AQuadraticSpringDoesNotGoForASineThatNothingShows) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].mass_kg.value = 1, rig.dofs[0].rotating = true;
  rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
  rig.links[0].stiffness_N_m.estimate = rig.links[0].viscous_N_s_m.estimate = true;
  const System system = make_system(rig);
  const std::vector<Prepared> records = prepare_all(rig, {decay()}, {});
  const Task task{system, records, 1};
  const Choice choice = rig_fitted(task);
  const Term spring = on_link(Kind::kQuadraticStiffness, 0);
  Term sine = on_link(Kind::kCogging, 0, kPitch_rad);
  Candidate cogging;
  cogging.terms = {sine}, cogging.complexity = 2;
  const State both = attempt(task, choice.base, {{{spring}, -1, 0, 0}, cogging}, {{0.0}, {0.1}}, kBaseSteps).state;
  ASSERT_TRUE(both.fit.ok);
  std::vector<Named> causes = {named(spring), named(sine)};
  State now = both;
  drop_needless(task, choice.base, now, causes);
  EXPECT_TRUE(std::any_of(causes.begin(), causes.end(),
                          [](const Named& n) { return n.candidate.terms[0].kind == Kind::kQuadraticStiffness; }));
  EXPECT_TRUE(all_shown(task, now.model));
}

// Bristles that bend over 50 mrad at some 4 rad/s take 12 ms. A nanosecond of damping of their own is none, 20 ms are.
TEST(Needless, ADampingOfBristlesThatIsNothingGoes) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].mass_kg.value = 1, rig.dofs[0].rotating = true;
  rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
  rig.links[0].stiffness_N_m.value = 100;
  const System system = make_system(rig);
  const std::vector<Prepared> records = prepare_all(rig, {decay()}, {});
  const Task task{system, records, 1};
  for (const double time_s : {1e-9, 0.02}) {
    Term bristles = on_link(Kind::kPresliding, 0, 0.05);
    bristles.shape2 = time_s;
    std::vector<Named> causes = {named(bristles)};
    State now = rig_fitted(task).base;
    ModelTerm friction;
    friction.term = bristles, friction.value = 0.2, friction.added = friction.shape_free = friction.shape2_free = true;
    now.model.push_back(friction);
    drop_idle_damping(task, now, causes);
    const ModelTerm& left = now.model.back();
    EXPECT_EQ(left.shape2_free, time_s > 1e-3);
    EXPECT_EQ(left.term.shape2, time_s > 1e-3 ? time_s : 0.0);
    EXPECT_EQ(causes[0].candidate.terms[0].shape2, time_s > 1e-3 ? time_s : 0.0);
  }
}

}  // namespace
