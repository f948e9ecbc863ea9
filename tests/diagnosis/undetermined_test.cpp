// Numbers whose intervals are wider than all that they are a part of.
#include "host_sim/diagnosis/numbers/undetermined.hpp"

#include <gtest/gtest.h>

#include "host_sim/diagnosis/numbers/parameter_status.hpp"

namespace diagnosis::runs {
namespace {

// One mass on the ground that moves at 0.5 m/s rms: v = +-0.5.
struct OneLink {
  rig_file::RigModel rig;
  std::vector<Prepared> records = std::vector<Prepared>(1);
  OneLink() {
    rig.dofs.resize(1), rig.links.resize(1);
    rig.dofs[0].mass_kg.value = 1;
    rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
    rig.links[0].viscous_N_s_m.estimate = rig.links[0].coulomb_N.estimate = true;
    Vec v(4);
    v << 0.5, -0.5, 0.5, -0.5;
    records[0].samples = 4;
    records[0].guess = {{true, v, v, v}, {}};
  }
  Diagnosis with(double viscous_std, double coulomb, double coulomb_std) const {
    const System system = make_system(rig);
    Diagnosis d;
    d.baseline.parameters = {{"viscous[1-0]", 3, "N s/m", viscous_std}, {"coulomb[1-0]", coulomb, "N", coulomb_std}};
    mark_undetermined(Task{system, records, 1}, d);
    return d;
  }
};

std::string statuses(const Diagnosis& d) {
  std::string all;
  for (const diagnosis::Parameter& p : d.baseline.parameters) all += std::string(status_word(p, true)) + " ";
  return all;
}

// 3 N s/m at 0.5 m/s are 1.5 N, with 2 N of friction 3.5 N. 1.96 times 0.1 N s/m are 0.1 N of force, 1.96 times 0.2 N are 0.39 N.
TEST(UndeterminedNumbers, NarrowIntervalsAreValid) {
  EXPECT_EQ(statuses(OneLink().with(0.1, 2, 0.2)), "VALID VALID ");
  EXPECT_TRUE(OneLink().with(0.1, 2, 0.2).advice.empty());
}

// Friction of -1 N +- 0.39 N cannot be, and the damper beside it holds what that lacks.
TEST(UndeterminedNumbers, WhatStandsBesideAnImpossibleNumberIsNotVouchedFor) {
  const Diagnosis d = OneLink().with(0.1, -1, 0.2);
  EXPECT_EQ(statuses(d), "BIAS_SUSPECT BIAS_SUSPECT ");
  ASSERT_EQ(d.advice.size(), 1u);
  EXPECT_EQ(d.advice[0].rfind("coulomb[1-0] below nought cannot be", 0), 0u);
}

// Friction of 0 +- 0.39 N beside 1.5 N is an answer: there is hardly any.
TEST(UndeterminedNumbers, NearlyNoughtBesideMoreIsValid) {
  EXPECT_EQ(statuses(OneLink().with(0.1, 0, 0.2)), "VALID VALID ");
}

// 1.96 times 2 N s/m are 1.96 N of 1.5 N; and then the friction's 0.39 N are held against 0 N alone.
TEST(UndeterminedNumbers, WideIntervalsAreNot) {
  const Diagnosis d = OneLink().with(2, 0, 0.2);
  EXPECT_EQ(statuses(d), "ILL_CONDITIONED ILL_CONDITIONED ");
  ASSERT_EQ(d.advice.size(), 1u);
  EXPECT_EQ(d.advice[0].rfind("these records do not tell viscous[1-0], coulomb[1-0]: ", 0), 0u);
}

// Beside 4 N of well known friction the damper's 1.96 N are less than all.
TEST(UndeterminedNumbers, IsHeldAgainstTheWholeForceOfTheLink) {
  EXPECT_EQ(statuses(OneLink().with(2, 4, 0.2)), "VALID VALID ");
}

// A torque of gravity of 7.6 +- 8.1 N m is none, one of 7.6 +- 0.8 N m is one.
TEST(UndeterminedNumbers, AWeightIsHeldAgainstItself) {
  for (const double std : {4.15, 0.4}) {
    const OneLink rig;
    const System system = make_system(rig.rig);
    Diagnosis d;
    d.baseline.parameters = {{"gravity_torque[1-0]", 7.6, "N m", std}};
    mark_undetermined(Task{system, rig.records, 1}, d);
    EXPECT_EQ(statuses(d), std > 1 ? "ILL_CONDITIONED " : "VALID ");
  }
}

}  // namespace
}  // namespace diagnosis::runs
