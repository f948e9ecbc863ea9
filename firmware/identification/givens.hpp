// Least squares by Givens rotations: rows go in one by one, the triangular factor R and the rotated right-hand side
// stay.
//
// Arithmetic: block-floating throughout (scaled.hpp), each operation rounds below 2^-60 relative; columns need no
// scaling. Work per row: at most unknowns^2 / 2 rotations of two entries. A rotation that meets an exact zero costs
// nothing, so rows of a chain stay cheap.
#pragma once
#include "firmware/configuration/capacity.hpp"
#include "firmware/fixed_point/scaled.hpp"
#include "firmware/identification/rows.hpp"

namespace firmware {

class TriangularFactor {
 public:
  void clear(int unknowns);
  void add(const Row& row);  // keeps the row as it is
  int unknowns() const { return unknowns_; }
  uint32_t rows() const { return rows_; }

  // A column is determined when its diagonal entry is over 2^-36 of the column's norm; others get p = 0.
  bool determined(int column) const;
  void solve(Scaled* parameters) const;
  // After all rows: R^-1 with undetermined columns left out (their rows and columns are zero).
  void invert();
  Scaled inverse(int row, int column) const { return inverse_[at(row, column)]; }  // row <= column
  Scaled factor(int row, int column) const { return factor_[at(row, column)]; }    // row <= column
  // result = (R^T R)^-1 vector.
  void apply_covariance(const Scaled* vector, Scaled* result) const;
  Scaled covariance(int row, int column) const;
  Scaled column_norm(int column) const;
  Scaled residual_square() const { return residual_square_; }

 private:
  // Place of an entry of a triangle: column by column, each down to its diagonal.
  static constexpr int at(int row, int column) { return column * (column + 1) / 2 + row; }
  static constexpr int kTriangle = kMaxUnknowns * (kMaxUnknowns + 1) / 2;

  int unknowns_ = 0;
  uint32_t rows_ = 0;
  Scaled factor_[kTriangle], rotated_[kMaxUnknowns];  // R, and the right-hand side
  Scaled inverse_[kTriangle];
  Scaled residual_square_;
};

}  // namespace firmware
