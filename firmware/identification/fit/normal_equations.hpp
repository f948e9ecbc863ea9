// Least squares by normal equations N p = h: sums of products of rows go in, the Cholesky factor R (R^T R = N) comes
// out.
//
// Arithmetic: block-floating throughout (scaled.hpp), 62-bit mantissas; columns need no scaling. Squaring the rows
// costs half the digits of an ill-conditioned problem: with sums that are exact before they are rounded once, a
// variance inflation of 2^23 still leaves a diagonal above the rounding. What the estimates lose besides is found by
// the next pass of the fit, which solves for a change of the parameters from exact residuals (weighted_fit.hpp).
#pragma once
#include "firmware/configuration/capacity.hpp"
#include "firmware/fixed_point/scaled.hpp"
#include "firmware/identification/rows/rows.hpp"

namespace firmware {

class NormalEquations {
 public:
  void clear(int unknowns);
  void clear_right_side();  // R stays
  int unknowns() const { return unknowns_; }
  void add(const Row& row);             // one row
  void add_right_side(const Row& row);  // of a row that is in already
  // Sums over rows: of the products of two columns, of a column and the right-hand side, of the squared right-hand
  // side.
  void add_product(int i, int j, const Scaled& sum);
  void add_moment(int i, const Scaled& sum) { moment_[i] = moment_[i] + sum; }
  void add_square(const Scaled& sum) { square_ = square_ + sum; }

  // After the last product: R takes the place of N.
  void factorise();
  // After factorise() and the last moment: R^-T h takes the place of h.
  void substitute();
  // A column is determined when what the ones before leave of its squared norm is over 2^-46 of it; others get p = 0.
  bool determined(int column) const { return !factor_[at(column, column)].is_zero(); }
  void solve(Scaled* parameters) const { solve_for(moment_, unknowns_, parameters); }
  // How the columns before it make up a column: R share = its column of R. As many entries as there are before it.
  void combine(int column, Scaled* share) const { solve_for(&factor_[at(0, column)], column, share); }
  Scaled residual_square() const;                                                       // what the solution leaves
  const Scaled& factor(int row, int column) const { return factor_[at(row, column)]; }  // of R, row <= column
  Scaled column_norm(int column) const;

  // After factorise(): N^-1 with undetermined columns left out (their rows and columns are zero).
  void invert();
  const Scaled& covariance(int i, int j) const { return covariance_[i < j ? at(i, j) : at(j, i)]; }
  void apply_covariance(const Scaled* vector, Scaled* result) const;  // result = N^-1 vector

 private:
  // R x = right, of the first columns.
  void solve_for(const Scaled* right, int columns, Scaled* x) const;

  // Place of an entry of a triangle: column by column, each down to its diagonal.
  static constexpr int at(int row, int column) { return column * (column + 1) / 2 + row; }
  static constexpr int kTriangle = kMaxUnknowns * (kMaxUnknowns + 1) / 2;

  int unknowns_ = 0;
  Scaled factor_[kTriangle], moment_[kMaxUnknowns];  // N and h, then R and R^-T h
  Scaled covariance_[kTriangle];
  Scaled square_;
};

}  // namespace firmware
