// Hand-sized tables with the answer worked out beside them: solution, weights, control variates, standard deviation.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/identification/hand_table.hpp"

using firmware::EstimateStatus;
using firmware::TermKind;
using hand::HandTable;

// Eq. 4 at two levels: 2 c + F = 11 and 8 c + 2 F = 34 give c = 3 (from 4 c = 12), F = 5.
TEST(Weighting, TwoLevelsSolveViscousAndCoulomb) {
  HandTable t(1, {TermKind::kViscous, TermKind::kCoulomb}, {{0}, {0}});
  t.link(0, firmware::kGroundNode);
  t.level(true);
  for (int b = 0; b < 4; ++b) t.batch({{{2, 1}, 11}});
  t.level(true);
  for (int b = 0; b < 4; ++b) t.batch({{{8, 2}, 34}});
  const firmware::Estimates& e = t.identify();
  EXPECT_NEAR(t.value(0), 3.0, 1e-12);
  EXPECT_NEAR(t.value(1), 5.0, 1e-12);
  EXPECT_EQ(t.status(0), EstimateStatus::kValid);
  EXPECT_EQ(e.rows, 2u);
}

// One unknown, two levels of four batches with column 1.
//   level A: rhs 11, 9, 11, 9: sum 40, deviations +-1: variance of the sum 4 * 4 / 3 = 16/3
//   level B: rhs 19, 13, 19, 13: sum 64, deviations +-3: variance of the sum 4 * 36 / 3 = 48
// Rows 4 p = 40 and 4 p = 64 with these variances:
//   p = (4 * 40 / (16/3) + 4 * 64 / 48) / (16 / (16/3) + 16 / 48) = (30 + 16/3) / (10/3) = 10.6, variance 3/10; the weights
//   have 3 degrees of freedom and shares of 0.9 and 0.1: 1 + 4 (0.9 * 0.1 + 0.1 * 0.9) / 3 = 1.24 times as much.
// Degrees of freedom (3 for each level; shares 0.27 and 0.03 of the variance): 0.09 / ((0.0729 + 0.0009) / 3) = 3.6585;
// t = 3.1824 - 0.6585 * (3.1824 - 2.7764) = 2.9150.
TEST(Weighting, LevelsCountByTheirMeasuredScatter) {
  HandTable t(1, {TermKind::kViscous}, {{0}});
  t.link(0, firmware::kGroundNode);
  t.level(true);
  for (double rhs : {11.0, 9.0, 11.0, 9.0}) t.batch({{{1}, rhs}});
  t.level(true);
  for (double rhs : {19.0, 13.0, 19.0, 13.0}) t.batch({{{1}, rhs}});
  t.identify();
  EXPECT_NEAR(t.value(0), 10.6, 1e-9);
  EXPECT_NEAR(t.deviation(0), std::sqrt(0.3 * 1.24), 1e-9);
  const double half = rig_file::to_double(t.estimates->parameters[0].ci95_high) - t.value(0);
  EXPECT_NEAR(half / t.deviation(0), 2.9150, 1e-3);
}

// rhs = 10 + 2 * (elastic discrepancy): the noise of the row is all in the discrepancy. Over 12 batches the discrepancy
// sums to 4, so the plain sum gives 128 / 12 = 10.67; reduced by twice the discrepancy it gives 10.
TEST(Weighting, NoiseThatADiscrepancyShowsIsTakenOut) {
  HandTable t(1, {TermKind::kViscous}, {{0}});
  t.link(0, firmware::kGroundNode);
  t.level(true);
  for (int b = 0; b < 12; ++b) {
    const double noise = b % 3 == 0 ? 3.0 : -1.0;
    t.batch({{{1}, 10.0 + 2.0 * noise, 0.0, noise}});
  }
  t.identify();
  EXPECT_NEAR(t.value(0), 10.0, 1e-9);
}

// A discrepancy that is 1 in every batch is no noise (its sum, 12, is far beyond its scatter of 0.01): it is left
// alone, and the row keeps its own sum: (12 * 10) / 12 although the rhs follows the discrepancy's small scatter.
TEST(Weighting, DiscrepancyWithACauseIsNotUsed) {
  HandTable t(1, {TermKind::kViscous}, {{0}});
  t.link(0, firmware::kGroundNode);
  t.level(true);
  for (int b = 0; b < 12; ++b) {
    const double noise = b % 2 == 0 ? 0.01 : -0.01;
    t.batch({{{1}, 10.0 + 2.0 * noise, 0.0, 1.0 + noise}});
  }
  t.identify();
  EXPECT_NEAR(t.value(0), 10.0, 1e-9);
}

// Interval rows: every batch is a row, weighted by its motion energy V. Columns 1 and 2 times V = 1 and 4, rhs with
// errors
// +-0.1 sqrt(V) that cancel in pairs: p = sum(col rhs / V) / sum(col^2 / V).
//   per pair of V = 1: col 1, rhs 5.1 and 4.9; per pair of V = 4: col 2, rhs 10.2 and 9.8: both give p = 5.
TEST(Weighting, IntervalRowsCountByTheirMotionEnergy) {
  HandTable t(1, {TermKind::kViscous}, {{0}});
  t.link(0, firmware::kGroundNode);
  t.level(false);
  for (int pair = 0; pair < 5; ++pair) {
    t.batch({{{1}, 5.1, 0, 0, 1.0}});
    t.batch({{{1}, 4.9, 0, 0, 1.0}});
    t.batch({{{2}, 10.2, 0, 0, 4.0}});
    t.batch({{{2}, 9.8, 0, 0, 4.0}});
  }
  const firmware::Estimates& e = t.identify();
  EXPECT_EQ(e.rows, 20u);
  EXPECT_NEAR(t.value(0), 5.0, 1e-9);
  // Residuals over sqrt(V) are all 0.1: variance per row 0.01; information per row 1 (col^2 / V): 20 rows.
  // Lost to the fit: 20 / 19.
  EXPECT_NEAR(t.deviation(0), std::sqrt(0.01 / 20.0 * 20.0 / 19.0), 1e-6);
}

// A batch in which the DOF stands still (V = 0) says nothing and must not be divided by.
TEST(Weighting, BatchAtRestIsLeftOut) {
  HandTable t(1, {TermKind::kViscous}, {{0}});
  t.link(0, firmware::kGroundNode);
  t.level(false);
  for (int b = 0; b < 10; ++b) t.batch({{{1}, b % 2 ? 5.1 : 4.9, 0, 0, 1.0}});
  t.batch({{{0}, 0.3, 0, 0, 0.0}});
  const firmware::Estimates& e = t.identify();
  EXPECT_EQ(e.rows, 10u);
  EXPECT_NEAR(t.value(0), 5.0, 1e-9);
}

// One batch that is a part of a period: integrals of v^2 4, of x^2 5, of x v 2 (its discrepancy 0.5, its ends 1.5).
//   velocity row (2, 1 | 3), displacement row (3, 1 | 2.5), each column k and the right-hand side.
// The part of x that is orthogonal to v is x - v 2/4; its square has the integral 5 - 2^2/4 = 4. So the rows are
//   (2, 1 | 3) / 2 = (1, 0.5 | 1.5)   and   ((3, 1 | 2.5) - 0.5 (2, 1 | 3)) / 2 = (1, 0.25 | 0.5).
// The second batch moves with x = 2 v but for noise: x^2 16.05, v^2 4, x v 8: 0.05 of 16.05 is less than 2^-8. No such row.
TEST(LevelColumns, DisplacementRowsAreOrthogonalToVelocityRowsInEveryBatch) {
  HandTable t(1, {TermKind::kMass, TermKind::kViscous}, {{0}, {0}});
  t.link(0, firmware::kGroundNode);
  t.level(false);
  hand::DofEntry partial{{2, 1}, 3.0, 0.0, 0.5, 4.0};
  partial.displacement = {{3, 1}, 2.5, 5.0};
  partial.elastic_end = 1.5;
  hand::DofEntry along{{2, 1}, 3.0, 0.0, 0.0, 4.0};
  along.displacement = {{4, 2}, 6.0, 16.05};
  along.elastic_end = 8.0;
  t.batch({partial});
  t.batch({along});
  const firmware::EquationList list = firmware::list_equations(t.configuration, *t.table);
  ASSERT_EQ(list.count, 2);
  const auto owner = std::make_unique<firmware::LevelColumns>();
  firmware::LevelColumns& level = *owner;
  const firmware::Scaled nought[firmware::kMaxUnknowns];
  level.load(list, t.table->layout, t.table->level[0], nought, true);
  const auto number = [&](int place, int batch) {
    const firmware::WholeColumn column = level.column(place);
    return rig_file::to_double(firmware::Scaled::from_int(column.value[batch], column.exponent));
  };
  constexpr double kRounding = 1e-7;
  EXPECT_NEAR(number(level.term(0, 0), 0), 1.0, kRounding);
  EXPECT_NEAR(number(level.term(0, 1), 0), 0.5, kRounding);
  EXPECT_NEAR(number(level.residual(0), 0), 1.5, kRounding);
  EXPECT_NEAR(number(level.term(1, 0), 0), 1.0, kRounding);
  EXPECT_NEAR(number(level.term(1, 1), 0), 0.25, kRounding);
  EXPECT_NEAR(number(level.residual(1), 0), 0.5, kRounding);
  EXPECT_EQ(number(level.term(1, 0), 1), 0.0);
  EXPECT_EQ(number(level.residual(1), 1), 0.0);
  EXPECT_EQ(level.rows_used(0), 2);
  EXPECT_EQ(level.rows_used(1), 1);
}
