// Numbers whose intervals are wider than all that they are a part of: hand vectors, then a table with that much scatter.
#include <gtest/gtest.h>

#include "firmware/identification/conditions/excitation_check.hpp"
#include "tests/identification/hand_table.hpp"

using firmware::EstimateStatus;
using firmware::TermKind;
using hand::HandTable;

namespace {

// One mass on the ground. In each of four batches unit coefficients dissipate 0.25 J (viscous) and 0.5 J (Coulomb): a second at
// 0.5 m/s to and fro. 3 N s/m are 0.75 J of four batches each, 2 N are 1 J.
struct OneLink {
  HandTable table{1, {TermKind::kViscous, TermKind::kCoulomb}, {{0}, {0}}};
  firmware::Estimates estimates;
  OneLink() {
    table.link(0, firmware::kGroundNode);
    for (int t = 0; t < table.configuration.term_count; ++t) table.configuration.terms[t].place = 0;
    table.level(false);
    for (int b = 0; b < 4; ++b) table.batch({{{0.25, 0.5}, 1.75}});
    estimates.unknown_count = 2;
  }
  // Half widths of the intervals.
  std::string told(double viscous_half, double coulomb, double coulomb_half) {
    set(0, 3, viscous_half), set(1, coulomb, coulomb_half);
    const firmware::EquationList list = firmware::list_equations(table.configuration, *table.table);
    std::string text;
    for (int k = 0; k < 2; ++k)
      text += firmware::is_undetermined(list, *table.table, table.configuration, k, estimates) ? "no " : "yes ";
    return text;
  }
  void set(int k, double value, double half) {
    estimates.parameters[k].value = rig_file::to_scaled(value);
    estimates.parameters[k].ci95_low = rig_file::to_scaled(value - half);
    estimates.parameters[k].ci95_high = rig_file::to_scaled(value + half);
  }
};

}  // namespace

// 0.2 N s/m are 0.05 J of 1.75 J, 0.39 N are 0.2 J.
TEST(UndeterminedEstimate, NarrowIntervalsTell) { EXPECT_EQ(OneLink().told(0.2, 2, 0.39), "yes yes "); }

// Friction of 0 N known to 0.2 J, beside 0.75 J: there is hardly any.
TEST(UndeterminedEstimate, NearlyNoughtBesideMoreTells) { EXPECT_EQ(OneLink().told(0.2, 0, 0.39), "yes yes "); }

// 3.9 N s/m are 0.98 J of 0.75 J; and then the friction's 0.2 J stand beside nothing.
TEST(UndeterminedEstimate, WideIntervalsTellNothing) { EXPECT_EQ(OneLink().told(3.9, 0, 0.39), "no no "); }

// Beside 2 J of friction the damper's 0.98 J are less than all.
TEST(UndeterminedEstimate, IsHeldAgainstAllThatTheLinkDissipates) {
  EXPECT_EQ(OneLink().told(3.9, 4, 0.39), "yes yes ");
}

// A damper that the rig file gives dissipates what no column tells.
TEST(UndeterminedEstimate, BesideAGivenDamperNothingIsSaid) {
  OneLink one;
  one.table.known(TermKind::kViscous, 0, 10.0);
  EXPECT_EQ(one.told(3.9, 0, 5), "yes yes ");
}

// Two batches that differ by 40 %: 1 N s/m with a standard deviation of 0.14 J / sqrt(2) / 0.5 J = 0.2 N s/m, small enough to be told from
// others, but Student's interval of one degree of freedom is 12.7 of it: -1.5 to 3.5.
TEST(UndeterminedEstimate, IsIllConditioned) {
  HandTable t(1, {TermKind::kViscous}, {{0}});
  t.link(0, firmware::kGroundNode);
  t.level(false);
  for (double rhs : {0.6, 0.4}) t.batch({{{0.5}, rhs}});
  t.identify();
  EXPECT_NEAR(t.deviation(0), 0.2, 0.01);
  EXPECT_EQ(t.status(0), EstimateStatus::kIllConditioned);
  EXPECT_FALSE(t.estimates->inseparable);  // there is nothing beside it
}
