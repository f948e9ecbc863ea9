#include "firmware/identification/fit/normal_equations.hpp"

#include "firmware/fixed_point/work_meter.hpp"

namespace firmware {

namespace {

// A column whose diagonal is zero is not determined.
void divide_or_clear(Scaled& entry, const Scaled& diagonal) {
  if (diagonal.is_zero())
    entry = Scaled{};
  else
    entry /= diagonal;
}

}  // namespace

void NormalEquations::clear(int unknowns) {
  unknowns_ = unknowns;
  for (int i = 0; i < at(0, unknowns); ++i, report_work(12)) factor_[i] = Scaled{};
  clear_right_side();
}

void NormalEquations::clear_right_side() {
  square_ = Scaled{};
  for (int i = 0; i < unknowns_; ++i) moment_[i] = Scaled{};
}

void NormalEquations::add_product(int i, int j, const Scaled& sum) {
  Scaled& place = factor_[i < j ? at(i, j) : at(j, i)];
  place += sum;
}

void NormalEquations::add(const Row& row) {
  for (int j = 0; j < unknowns_; ++j) {
    if (row.column[j].is_zero()) continue;
    for (int i = 0; i <= j; ++i)
      if (!row.column[i].is_zero()) add_product(i, j, row.column[i] * row.column[j]);
  }
  add_right_side(row);
}

void NormalEquations::add_right_side(const Row& row) {
  for (int j = 0; j < unknowns_; ++j) add_moment(j, row.column[j] * row.rhs);
  add_square(row.rhs * row.rhs);
}

void NormalEquations::factorise() {
  for (int column = 0; column < unknowns_; ++column) {
    for (int row = 0; row <= column; ++row) {
      Scaled& entry = factor_[at(row, column)];
      const Scaled whole = entry;
      for (int k = 0; k < row; ++k) {
        const Scaled &a = factor_[at(k, row)], &b = factor_[at(k, column)];
        if (!a.is_zero() && !b.is_zero()) multiply_subtract(entry, a, b);
      }
      if (row < column)
        divide_or_clear(entry, factor_[at(row, row)]);
      else
        entry = entry > scale_by_power_of_two(whole, -46) ? sqrt(entry) : Scaled{};
    }
  }
}

void NormalEquations::substitute() {
  for (int column = 0; column < unknowns_; ++column) {
    Scaled& entry = moment_[column];
    for (int k = 0; k < column; ++k) multiply_subtract(entry, factor_[at(k, column)], moment_[k]);
    divide_or_clear(entry, factor_[at(column, column)]);
  }
}

Scaled NormalEquations::residual_square() const {
  Scaled left = square_;
  for (int k = 0; k < unknowns_; ++k) multiply_subtract(left, moment_[k], moment_[k]);
  return left.is_negative() ? Scaled{} : left;
}

Scaled NormalEquations::column_norm(int column) const {
  Scaled sum;
  for (int i = 0; i <= column; ++i) multiply_add(sum, factor_[at(i, column)], factor_[at(i, column)]);
  return sqrt(sum);
}

void NormalEquations::solve_for(const Scaled* right, int columns, Scaled* x) const {
  for (int k = columns - 1; k >= 0; --k) {
    x[k] = Scaled{};
    if (!determined(k)) continue;
    x[k] = right[k];
    for (int j = k + 1; j < columns; ++j) multiply_subtract(x[k], factor_[at(k, j)], x[j]);
    x[k] /= factor_[at(k, k)];
  }
}

// R^-1 first, then its product with its transpose in the same place: an entry is read for the last time when it is
// written.
void NormalEquations::invert() {
  Scaled* const x = covariance_;
  for (int column = 0; column < unknowns_; ++column) {
    for (int row = 0; row <= column; ++row) x[at(row, column)] = Scaled{};
    if (!determined(column)) continue;
    x[at(column, column)] = kScaledOne / factor_[at(column, column)];
    for (int row = column - 1; row >= 0; --row) {
      if (!determined(row)) continue;
      Scaled& entry = x[at(row, column)];
      for (int j = row + 1; j <= column; ++j) multiply_subtract(entry, factor_[at(row, j)], x[at(j, column)]);
      entry /= factor_[at(row, row)];
    }
  }
  for (int i = 0; i < unknowns_; ++i)
    for (int j = i; j < unknowns_; ++j) {
      Scaled sum;
      for (int k = j; k < unknowns_; ++k) multiply_add(sum, x[at(i, k)], x[at(j, k)]);
      x[at(i, j)] = sum;
    }
}

void NormalEquations::apply_covariance(const Scaled* vector, Scaled* result) const {
  for (int i = 0; i < unknowns_; ++i) {
    result[i] = Scaled{};
    for (int j = 0; j < unknowns_; ++j)
      if (!vector[j].is_zero()) multiply_add(result[i], covariance(i, j), vector[j]);
  }
}

}  // namespace firmware
