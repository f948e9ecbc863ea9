// Products of tall matrices: what a fit and a screening of candidates do most.
#pragma once

namespace diagnosis::runs {

// Rows of numbers, one after the other, each `size` wide and `stride` behind the one before.
struct Rows {
  const double* first;
  long size, stride;
};
// sum += sum over rows of a_row b_row^T, column by column (a.size x b.size). lower: what lies above its diagonal is not needed.
void add_outer_sums(const Rows& a, const Rows& b, long count, double* sum, bool lower = false);
// Of every number of a row, sums over rows: its square, its product with the number beside it, and with the row's `value`.
void add_row_sums(const Rows& a, const double* value, long count, double* square, double* with_next,
                  double* with_value);

}  // namespace diagnosis::runs
