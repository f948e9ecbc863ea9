// What is said of causes that no test bears out.
#include "host_sim/diagnosis/answer/possible_causes.hpp"

#include <gtest/gtest.h>

namespace diagnosis::runs {
namespace {

// One mass and one damper, beside which a quadratic spring takes 53 % of what is not noise.
struct OneLink {
  rig_file::RigModel rig;
  System system;
  std::vector<Prepared> records = std::vector<Prepared>(1);
  Choice choice;
  Diagnosis d;
  OneLink() {
    rig.dofs.resize(1), rig.links.resize(1);
    rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
    system = make_system(rig);
    choice.base_left.foreign_line = 1e6;  // beyond noise
    Candidate spring;
    spring.terms = {on_link(Kind::kQuadraticStiffness, 0)};
    choice.nearest = Nearly{spring, {}, 0.53};
    d.baseline.parameters = {{"viscous[1-0]", 3, "N s/m", 0.1}};
    d.verdict = Verdict::kUnknown;
  }
  void say() { say_possible(Task{system, records, 1}, choice, d); }
};

TEST(PossibleCauses, TheNearestIsToldWhereNothingExplains) {
  OneLink one;
  one.say();
  ASSERT_EQ(one.d.possible.size(), 1u);
  EXPECT_EQ(one.d.possible[0].place.effect, "quadratic_stiffness");
  EXPECT_EQ(one.d.possible[0].place.where, "link 1-0");
  EXPECT_DOUBLE_EQ(one.d.possible[0].explains_percent, 53.0);
  EXPECT_TRUE(one.d.possible[0].bends.empty());
  EXPECT_FALSE(one.d.baseline.parameters[0].may_be_bent);
}

TEST(PossibleCauses, TheNearestIsNotToldBesideWhatExplains) {
  OneLink right;
  right.d.verdict = Verdict::kNone;
  right.say();
  EXPECT_TRUE(right.d.possible.empty());
  OneLink noise;
  noise.choice.base_left.foreign_line = 0;
  noise.say();
  EXPECT_TRUE(noise.d.possible.empty());
  OneLink named;
  named.d.causes.resize(1);
  named.say();
  EXPECT_TRUE(named.d.possible.empty());
}

// What no test bears out gives way to what one nearly does.
TEST(PossibleCauses, TheNearestComesBehindWhatIsNearlySure) {
  OneLink one;
  Candidate damper;
  damper.terms = {on_link(Kind::kQuadraticDamping, 0)};
  one.choice.nearly = {Nearly{damper, {}, 0.4}};
  one.say();
  ASSERT_EQ(one.d.possible.size(), 1u);
  EXPECT_EQ(one.d.possible[0].place.effect, "quadratic_damping");
}

}  // namespace
}  // namespace diagnosis::runs
