// What is said beside a verdict contradicts neither it nor itself.
#include "host_sim/diagnosis/advice.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace diagnosis {
namespace {

bool says(const Diagnosis& d, const std::string& part) {
  const std::vector<std::string> list = advice_for(d);
  return std::any_of(list.begin(), list.end(), [&](const std::string& text) { return text.find(part) != text.npos; });
}

// chi-squared per degree of freedom: 1 is noise alone, 40 is far more
TEST(Advice, NothingBeyondNoiseIsSaidWhereOnlyNoiseIsLeft) {
  Diagnosis d;
  d.verdict = Verdict::kNone, d.baseline_misfit = 1;
  EXPECT_TRUE(says(d, "nothing beyond measurement noise: to see weaker effects"));
  d.baseline_misfit = 40;
  EXPECT_FALSE(says(d, "nothing beyond"));
  EXPECT_TRUE(says(d, "to see weaker effects"));
}

// A decay has no force to measure better.
TEST(Advice, OfADecayAsksForNoForce) {
  Diagnosis d;
  d.verdict = Verdict::kUnknown, d.baseline_misfit = 1;
  EXPECT_TRUE(says(d, "measure the force with less noise"));
  d.driven = false;
  EXPECT_FALSE(says(d, "force"));
  EXPECT_TRUE(says(d, "let it go from farther"));
}

TEST(Advice, AFaintTraceIsToldBesideNone) {
  Diagnosis d;
  d.verdict = Verdict::kNone, d.baseline_misfit = 1.2, d.unknown_trace = "a tone of 18.9 Hz on dof 1";
  EXPECT_FALSE(d.leaves_noise_alone());
  EXPECT_TRUE(says(d, "looks faintly like a tone of 18.9 Hz on dof 1"));
  EXPECT_FALSE(says(d, "nothing beyond"));
}

// A spring of 2000 N/m whose displacement reads 30 mm too much lacks -60 N all the time.
TEST(Advice, ConstantForceOfASpringMayBeTheZeroOfItsDisplacement) {
  Diagnosis d;
  d.verdict = Verdict::kExplained;
  d.extended_rig.links.resize(1);
  d.extended_rig.links[0].a = 1, d.extended_rig.links[0].b = rig_file::kGround;
  Cause offset;
  offset.effect = "force_offset", offset.where = "link 1-0";
  offset.parameters.resize(1);
  offset.parameters[0].value = -60, offset.parameters[0].unit = "N";
  d.causes = {offset};
  EXPECT_FALSE(says(d, "displacement over"));  // no spring yet: nothing else looks like it
  d.extended_rig.links[0].stiffness_N_m.value = 2000;
  EXPECT_TRUE(says(d, "displacement over link 1-0 that reads 0.03 m too much looks the same"));
  d.causes[0].parameters[0].value = 60;
  EXPECT_TRUE(says(d, "reads 0.03 m too little"));
}

// A pendulum of 4.8 N m that hangs 0.035 rad beside the zero of its angle lacks -0.168 N m.
TEST(Advice, ConstantTorqueOfAPendulumMayBeTheZeroOfItsAngle) {
  Diagnosis d;
  d.verdict = Verdict::kExplained;
  d.extended_rig.links.resize(1);
  d.extended_rig.links[0].a = 1, d.extended_rig.links[0].b = rig_file::kGround;
  d.extended_rig.links[0].gravity_torque_N_m.value = 4.8;
  Cause offset;
  offset.effect = "force_offset", offset.where = "link 1-0";
  offset.parameters.resize(1);
  offset.parameters[0].value = -0.168, offset.parameters[0].unit = "N m";
  d.causes = {offset};
  EXPECT_TRUE(says(d, "displacement over link 1-0 that reads 0.035 rad too much looks the same"));
  d.extended_rig.links[0].gravity_torque_N_m.estimate = true;  // its size is what was found
  EXPECT_FALSE(says(d, "displacement over"));
  d.extended.parameters = {{"gravity_torque[1-0]", 3.36, "N m", 0.01}};
  EXPECT_TRUE(says(d, "displacement over link 1-0 that reads 0.05 rad too much looks the same"));
}

}  // namespace
}  // namespace diagnosis
