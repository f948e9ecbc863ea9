// Numbers that hang on which of several causes it is.
#include "host_sim/diagnosis/numbers/between_rivals.hpp"

#include <gtest/gtest.h>

#include "host_sim/diagnosis/choice/round.hpp"
#include "host_sim/diagnosis/numbers/parameter_status.hpp"

namespace {

using namespace diagnosis;

// 3 kg on the ground by a damper that is asked for.
rig_file::RigModel damped_mass() {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].mass_kg.value = 3;
  rig.links[0].a = 1;
  rig.links[0].viscous_N_s_m.estimate = true;
  return rig;
}

// A damper of 11 +- 0.2 beside the cause named. 1.96 x 0.2 = 0.39: a rival that makes it 10 takes it out, one that makes it 10.7 does not.
// rivals_dampers: beside a missing friction, an end stop and a backlash, in turn. error: squared, of each over that of the cause named.
Diagnosis answer_beside(const std::vector<double>& rivals_dampers, double error = 1) {
  const rig_file::RigModel rig = damped_mass();
  const System system = make_system(rig, true);
  runs::Named named;
  named.candidate.terms = {on_link(Kind::kStribeck, 0, 0.2)};
  const Term rivals[] = {on_link(Kind::kMissingCoulomb, 0), on_link(Kind::kEndStop, 0, 0.1),
                         on_link(Kind::kBacklash, 0, 0.1)};
  for (size_t i = 0; i < rivals_dampers.size(); ++i) {
    runs::Candidate other;
    other.terms = {rivals[i]};
    named.rivals.push_back({other, error, {{"viscous[1-0]", rivals_dampers[i] - 11}}});
  }
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
  const Diagnosis d = answer_beside({10});
  EXPECT_STREQ(status_word(d.extended.parameters[0], true), "BIAS_SUSPECT");
  ASSERT_EQ(d.advice.size(), 1u);
  EXPECT_EQ(d.advice[0], "viscous[1-0] is 11 with the cause named, 10 with Coulomb friction on link 1-0 in its place");
}

// Who reads that one of two is missing takes the number for both.
TEST(BetweenRivals, ARivalThatLeavesMoreButIsSaidCountsToo) {
  EXPECT_STREQ(status_word(answer_beside({10}, 1.3).extended.parameters[0], true), "BIAS_SUSPECT");
}

TEST(BetweenRivals, OfManyThoseAreToldThatTakeItFarthest) {
  const Diagnosis d = answer_beside({10, 14, 9});
  ASSERT_EQ(d.advice.size(), 1u);
  EXPECT_EQ(d.advice[0],
            "viscous[1-0] is 11 with the cause named, 9 with backlash on link 1-0 in its place, 14 with end stop on "
            "link 1-0");
}

TEST(BetweenRivals, WhatStaysInItsIntervalIs) {
  const Diagnosis d = answer_beside({10.7});
  EXPECT_STREQ(status_word(d.extended.parameters[0], true), "VALID");
  EXPECT_TRUE(d.advice.empty());
}

// One cause beside another that two may be. What the rig and the sure cause have is compared name by name, in whatever order the models
// have them; what the one has that the other stands in for is in no rival.
TEST(BetweenRivals, NumbersOfTheOtherCausesMoveToo) {
  const rig_file::RigModel rig = damped_mass();
  const System system = make_system(rig, true);
  const std::vector<runs::Prepared> records;
  const auto term = [](const Term& t, double value, bool added) {
    runs::ModelTerm m;
    m.term = t, m.value = value, m.known = false, m.added = added;
    return m;
  };
  const auto damper = [&](double value) { return term(on_link(Kind::kViscous, 0), value, false); };
  const auto sine = [&](double value, double pitch, double phase) {
    Term t = on_link(Kind::kCogging, 0, pitch);
    t.shape2 = phase;
    return term(t, value, true);
  };
  const auto cubic = term(on_link(Kind::kCubicStiffness, 0), 50, true),
             drag = term(on_link(Kind::kQuadraticDamping, 0), 7, true);
  const runs::Model rest = {damper(9), sine(1, 0.3, 0)}, named = {damper(11), cubic, sine(2, 0.3, 3.1)},
                    rival = {damper(10), sine(5, 0.4, -3.1), drag};
  const std::vector<runs::Move> moves = runs::moves_between({system, records, 0}, rest, named, rival);
  ASSERT_EQ(moves.size(), 4u);
  const char* names[] = {"viscous[1-0]", "cogging[1-0]", "cogging_pitch[1-0]", "cogging_phase[1-0]"};
  const double by[] = {-1, 3, 0.1, 6.283185 - 6.2};
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(moves[i].name, names[i]);
    EXPECT_NEAR(moves[i].by, by[i], 1e-5);
  }
}

Parameter sure_number(const char* name) {
  Parameter p;
  p.name = name, p.value = 5, p.std = 0.1;
  return p;
}

// Beside a sine that is sure it is a cubic spring or an end stop: the spring's coefficient is nought where it is the stop.
TEST(BetweenRivals, NumbersOfACauseThatMayBeAnotherAreNotVouchedFor) {
  Diagnosis d;
  d.verdict = Verdict::kAmbiguous;
  for (const char* name : {"cubic_stiffness[1-0]", "cogging[1-0]", "viscous[1-0]"})
    d.extended.parameters.push_back(sure_number(name));
  Cause spring, sine;
  spring.parameters = {d.extended.parameters[0]}, sine.parameters = {d.extended.parameters[1]};
  spring.rivals = d.ambiguous_with = {{"end_stop", "link 1-0"}};
  d.causes = {spring, sine};
  const auto status = [&](size_t i) { return std::string(status_word(d.extended.parameters[i], d.extended_fits())); };
  runs::mark_replaceable(d);
  EXPECT_EQ(status(0), "BIAS_SUSPECT");
  EXPECT_EQ(status(1), "VALID");
  EXPECT_EQ(status(2), "VALID");
  d.causes[0].rivals.clear();  // which of them it is in whose place another may stand is not known
  runs::mark_replaceable(d);
  EXPECT_EQ(status(1), "BIAS_SUSPECT");
  EXPECT_EQ(status(2), "VALID");
}

TEST(BetweenRivals, NumbersOfCausesWithoutEqualsAre) {
  Diagnosis d;
  d.verdict = Verdict::kExplained;
  d.extended.parameters = {sure_number("cubic_stiffness[1-0]")};
  Cause spring;
  spring.parameters = d.extended.parameters;
  d.causes = {spring};
  runs::mark_replaceable(d);
  EXPECT_STREQ(status_word(d.extended.parameters[0], d.extended_fits()), "VALID");
}

}  // namespace
