// Normal equations and Student quantile against numbers worked out by hand or printed in tables.
#include <gtest/gtest.h>

#include "firmware/identification/fit/normal_equations.hpp"
#include "firmware/identification/intervals/student_quantile.hpp"
#include "hal/rig_file/scaled_double.hpp"

namespace {

firmware::Row row(double a, double b, double rhs) {
  firmware::Row result;
  result.column[0] = rig_file::to_scaled(a);
  result.column[1] = rig_file::to_scaled(b);
  result.rhs = rig_file::to_scaled(rhs);
  return result;
}

double quantile(double freedom) {
  return rig_file::to_double(firmware::student_quantile_95(rig_file::to_scaled(freedom)));
}

}  // namespace

// Rows (1, 0 | 1), (0, 2 | 2), (1, 1 | 3): normal matrix [2 1; 1 5], right side (4, 7), determinant 9:
// p = (13/9, 10/9), inverse [5 -1; -1 2] / 9; residuals (-4/9, -2/9, 4/9): sum of squares 36/81.
TEST(NormalEquations, ThreeRowsTwoUnknowns) {
  firmware::NormalEquations factor;
  factor.clear(2);
  factor.add(row(1, 0, 1));
  factor.add(row(0, 2, 2));
  factor.add(row(1, 1, 3));
  factor.factorise();
  factor.substitute();
  firmware::Scaled p[firmware::kMaxUnknowns];
  factor.solve(p);
  EXPECT_NEAR(rig_file::to_double(p[0]), 13.0 / 9.0, 1e-15);
  EXPECT_NEAR(rig_file::to_double(p[1]), 10.0 / 9.0, 1e-15);
  EXPECT_NEAR(rig_file::to_double(factor.residual_square()), 36.0 / 81.0, 1e-15);
  factor.invert();
  EXPECT_NEAR(rig_file::to_double(factor.covariance(0, 0)), 5.0 / 9.0, 1e-15);
  EXPECT_NEAR(rig_file::to_double(factor.covariance(0, 1)), -1.0 / 9.0, 1e-15);
  EXPECT_NEAR(rig_file::to_double(factor.covariance(1, 1)), 2.0 / 9.0, 1e-15);
}

TEST(NormalEquations, DependentColumnIsNotDetermined) {
  firmware::NormalEquations factor;
  factor.clear(2);
  factor.add(row(1, 3, 1));
  factor.add(row(2, 6, 2));
  factor.factorise();
  EXPECT_TRUE(factor.determined(0));
  EXPECT_FALSE(factor.determined(1));
}

// Columns twelve orders of magnitude apart lose nothing: p = (1, 1e12).
TEST(NormalEquations, ScaleOfColumnsDoesNotMatter) {
  firmware::NormalEquations factor;
  factor.clear(2);
  factor.add(row(1, 1e-12, 2));
  factor.add(row(1, -1e-12, 0));
  factor.factorise();
  factor.substitute();
  firmware::Scaled p[firmware::kMaxUnknowns];
  factor.solve(p);
  EXPECT_NEAR(rig_file::to_double(p[0]), 1.0, 1e-14);
  EXPECT_NEAR(rig_file::to_double(p[1]) * 1e-12, 1.0, 1e-14);
}

// Two-sided 5 % points of Student's t as in any statistical table.
TEST(StudentQuantile, PrintedTable) {
  EXPECT_NEAR(quantile(1), 12.706, 1e-3);
  EXPECT_NEAR(quantile(2), 4.303, 1e-3);
  EXPECT_NEAR(quantile(5), 2.571, 1e-3);
  EXPECT_NEAR(quantile(6), 2.447, 1e-3);
  EXPECT_NEAR(quantile(10), 2.228, 1e-3);
  EXPECT_NEAR(quantile(30), 2.042, 1e-3);
  EXPECT_NEAR(quantile(1e6), 1.960, 1e-3);
}

TEST(StudentQuantile, BetweenTableEntries) {
  EXPECT_NEAR(quantile(3.5), (3.1824 + 2.7764) / 2.0, 1e-3);
  EXPECT_NEAR(quantile(0.2), 12.706, 1e-3);
}
