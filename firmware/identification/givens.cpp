#include "firmware/identification/givens.hpp"

namespace firmware {

void TriangularFactor::clear(int unknowns) {
  unknowns_ = unknowns;
  rows_ = 0;
  residual_square_ = Scaled{};
  for (int i = 0; i < at(0, unknowns); ++i) factor_[i] = Scaled{};
  for (int i = 0; i < unknowns; ++i) rotated_[i] = Scaled{};
}

void TriangularFactor::add(const Row& row) {
  Scaled rest[kMaxUnknowns + 1];
  for (int k = 0; k < unknowns_; ++k) rest[k] = row.column[k];
  rest[unknowns_] = row.rhs;
  ++rows_;
  for (int k = 0; k < unknowns_; ++k) {
    if (rest[k].is_zero()) continue;
    Scaled& diagonal = factor_[at(k, k)];
    const Scaled radius = sqrt(diagonal * diagonal + rest[k] * rest[k]);
    const Scaled cosine = diagonal / radius, sine = rest[k] / radius;
    diagonal = radius;
    for (int j = k + 1; j <= unknowns_; ++j) {
      Scaled& entry = j < unknowns_ ? factor_[at(k, j)] : rotated_[k];
      const Scaled upper = entry, lower = rest[j];
      entry = cosine * upper + sine * lower;
      rest[j] = cosine * lower - sine * upper;
    }
  }
  residual_square_ = residual_square_ + rest[unknowns_] * rest[unknowns_];
}

Scaled TriangularFactor::column_norm(int column) const {
  Scaled sum;
  for (int i = 0; i <= column; ++i) sum = sum + factor_[at(i, column)] * factor_[at(i, column)];
  return sqrt(sum);
}

bool TriangularFactor::determined(int column) const {
  return !factor_[at(column, column)].is_zero() &&
         abs(factor_[at(column, column)]) > scale_by_power_of_two(column_norm(column), -36);
}

void TriangularFactor::solve(Scaled* parameters) const {
  for (int k = unknowns_ - 1; k >= 0; --k) {
    parameters[k] = Scaled{};
    if (!determined(k)) continue;
    Scaled sum = rotated_[k];
    for (int j = k + 1; j < unknowns_; ++j) sum = sum - factor_[at(k, j)] * parameters[j];
    parameters[k] = sum / factor_[at(k, k)];
  }
}

void TriangularFactor::invert() {
  bool known[kMaxUnknowns];
  for (int column = 0; column < unknowns_; ++column) {
    for (int row = 0; row <= column; ++row) inverse_[at(row, column)] = Scaled{};
    known[column] = determined(column);
    if (!known[column]) continue;
    inverse_[at(column, column)] = Scaled::from_int(1) / factor_[at(column, column)];
    for (int row = column - 1; row >= 0; --row) {
      if (!known[row]) continue;
      Scaled sum;
      for (int j = row + 1; j <= column; ++j) sum = sum - factor_[at(row, j)] * inverse_[at(j, column)];
      inverse_[at(row, column)] = sum / factor_[at(row, row)];
    }
  }
}

void TriangularFactor::apply_covariance(const Scaled* vector, Scaled* result) const {
  Scaled middle[kMaxUnknowns];
  for (int j = 0; j < unknowns_; ++j) {
    middle[j] = Scaled{};
    for (int i = 0; i <= j; ++i) middle[j] = middle[j] + inverse_[at(i, j)] * vector[i];
  }
  for (int i = 0; i < unknowns_; ++i) {
    result[i] = Scaled{};
    for (int j = i; j < unknowns_; ++j) result[i] = result[i] + inverse_[at(i, j)] * middle[j];
  }
}

Scaled TriangularFactor::covariance(int row, int column) const {
  Scaled sum;
  for (int j = row > column ? row : column; j < unknowns_; ++j)
    sum = sum + inverse_[at(row, j)] * inverse_[at(column, j)];
  return sum;
}

}  // namespace firmware
