// Numbers that hang on which of several causes it is.
#include "host_sim/diagnosis/answer/between_rivals.hpp"

#include <gtest/gtest.h>

#include "host_sim/diagnosis/answer/parameter_status.hpp"

namespace {

using namespace diagnosis;

// A damper of 11 +- 0.2 beside the cause named. 1.96 x 0.2 = 0.39: a rival that makes it 10 takes it out, one that makes it 10.7 does not.
Diagnosis answer_beside(double rivals_damper) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].mass_kg.value = 3;
  rig.links[0].a = 1;
  rig.links[0].viscous_N_s_m.estimate = true;
  const System system = make_system(rig, true);
  runs::Candidate stribeck, dry;
  stribeck.terms = {on_link(Kind::kStribeck, 0, 0.2)}, dry.terms = {on_link(Kind::kMissingCoulomb, 0)};
  runs::Named named;
  named.candidate = stribeck;
  named.rivals = {{dry, 1.0, {{on_link(Kind::kViscous, 0), rivals_damper - 11}}}};
  runs::Choice choice;
  choice.named = {named};
  Diagnosis d;
  Parameter damper;
  damper.name = "viscous[1-0]", damper.value = 11, damper.std = 0.2;
  d.extended.parameters = {damper};
  const std::vector<runs::Prepared> records;
  runs::mark_between_rivals({system, records, 0}, choice, d);
  return d;
}

TEST(BetweenRivals, WhatARivalTakesOutOfItsIntervalIsNotVouchedFor) {
  const Diagnosis d = answer_beside(10);
  EXPECT_STREQ(status_word(d.extended.parameters[0], true), "BIAS_SUSPECT");
  ASSERT_EQ(d.advice.size(), 1u);
  EXPECT_EQ(d.advice[0], "viscous[1-0] is 11 with the cause named, 10 with missing coulomb on link 1-0 in its place");
}

TEST(BetweenRivals, WhatStaysInItsIntervalIs) {
  const Diagnosis d = answer_beside(10.7);
  EXPECT_STREQ(status_word(d.extended.parameters[0], true), "VALID");
  EXPECT_TRUE(d.advice.empty());
}

}  // namespace
