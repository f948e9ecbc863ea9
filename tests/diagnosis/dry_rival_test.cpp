// Dry friction as the rival of bristles that bend, beside other causes: only the bristles are exchanged for it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "host_sim/diagnosis/choice/choice.hpp"
#include "host_sim/diagnosis/trial/attempt.hpp"
#include "host_sim/diagnosis/trial/bristles.hpp"
#include "tests/hidden_rig/draw.hpp"
#include "two_masses.hpp"

namespace {

using namespace diagnosis;
using namespace diagnosis::runs;

// A damper moved by hand, 20 mm at 1 Hz, 100 Hz: 500 N s/m, 200 N whose bristles bend over 2 mm, 4000 N s^2/m^2; 1 N of noise. In
// 100 steps a sample.
host_sim::Record record_of_damper() {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  host_sim::Record r;
  r.file = "damper.csv", r.sample_period_s = 0.01;
  std::vector<double> x, f;
  const double w = 2 * 3.14159265358979, step = r.sample_period_s / 100;
  const auto rate = [&](double t) { return 0.02 * w * std::cos(w * t); };
  double z = 0;
  for (int i = 0; i < 2000; ++i) {
    const double t = i * r.sample_period_s, v = rate(t);
    x.push_back(0.02 * std::sin(w * t));
    f.push_back(500 * v + 200 * z + 4000 * v * std::abs(v) + normal(random));
    for (int k = 0; k < 100; ++k) {
      const double middle = rate(t + (k + 0.5) * step);
      z += (middle - std::abs(middle) * z) / 0.002 * step;
    }
  }
  r.channels = {{"displacement_1_m", host_sim::Quantity::kDisplacement, 1, x},
                {"force_1_N", host_sim::Quantity::kForce, 1, f}};
  return r;
}

bool holds(const Model& model, Kind kind) {
  return std::any_of(model.begin(), model.end(), [&](const ModelTerm& t) { return t.added && t.term.kind == kind; });
}

// The bristles stand before the quadratic damping in the model. own_friction: the rig file has dry friction, in whose place they
// act, and which comes back.
void exchange(bool own_friction) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
  rig.links[0].viscous_N_s_m.estimate = true, rig.links[0].coulomb_N.estimate = own_friction;
  const System system = make_system(rig);
  const std::vector<Prepared> records = prepare_all(rig, {record_of_damper()}, {});
  const Task task{system, records, 1};
  Choice choice = rig_fitted(task);
  Candidate bristles, quadratic;
  bristles.terms = {on_link(Kind::kPresliding, 0, 0.002)}, bristles.complexity = 1;
  for (size_t i = 0; i < choice.base.model.size(); ++i)
    if (choice.base.model[i].term.kind == Kind::kCoulomb) bristles.host = static_cast<int>(i);
  ASSERT_EQ(bristles.host >= 0, own_friction);
  quadratic.terms = {on_link(Kind::kQuadraticDamping, 0)};
  Attempt own = attempt(task, choice.base, {bristles, quadratic}, {{0.0}, {0.0}}, kBaseSteps);
  ASSERT_TRUE(own.state.fit.ok);
  own.candidates = {bristles};
  const Attempt dry = without_bristles(task, choice.base, own);
  EXPECT_FALSE(holds(dry.state.model, Kind::kPresliding));
  EXPECT_EQ(holds(dry.state.model, Kind::kMissingCoulomb), !own_friction);
  ASSERT_TRUE(holds(dry.state.model, Kind::kQuadraticDamping));
  EXPECT_TRUE(dry.state.fit.ok);
  for (const ModelTerm& t : dry.state.model) EXPECT_LT(t.host, 0);
  // bristles that lag behind each turn leave an error of some 200 N over 2 of 80 mm a period
  EXPECT_GT(error_over(dry.state.fit, own.state.fit), 10);
}

TEST(DryRival, OfBristlesLeavesOtherCausesAlone) { exchange(false); }
TEST(DryRival, OfBristlesInTheRigsOwnFrictionGivesThatBack) { exchange(true); }

// The rig's own friction follows as well as bristles in its place and brings nothing itself: neither is named. Masses and springs are
// unknown, velocities measured.
TEST(DryRival, ThatIsTheRigsOwnFrictionAndBringsNothingIsNoCause) {
  hidden_rig::Settings settings;
  settings.condition = "masses_springs_unknown", settings.sensors = "v";
  const hidden_rig::Draw draw = hidden_rig::make_draw(34200003, settings);
  EXPECT_EQ(two_masses::said(diagnose(draw.rig, draw.records, {})), "none");
}

}  // namespace
