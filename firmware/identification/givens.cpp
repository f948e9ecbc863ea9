#include "firmware/identification/givens.hpp"

namespace firmware {

void TriangularFactor::clear(int unknowns) {
  unknowns_ = unknowns;
  rows_ = 0;
  residual_square_ = Scaled{};
  for (int i = 0; i < unknowns; ++i)
    for (int j = 0; j <= unknowns; ++j) factor_[i][j] = Scaled{};
}

void TriangularFactor::add(const Row& row) {
  Scaled rest[kMaxUnknowns + 1];
  for (int k = 0; k < unknowns_; ++k) rest[k] = row.column[k];
  rest[unknowns_] = row.rhs;
  ++rows_;
  for (int k = 0; k < unknowns_; ++k) {
    if (rest[k].is_zero()) continue;
    const Scaled radius = sqrt(factor_[k][k] * factor_[k][k] + rest[k] * rest[k]);
    const Scaled cosine = factor_[k][k] / radius, sine = rest[k] / radius;
    factor_[k][k] = radius;
    for (int j = k + 1; j <= unknowns_; ++j) {
      const Scaled upper = factor_[k][j], lower = rest[j];
      factor_[k][j] = cosine * upper + sine * lower;
      rest[j] = cosine * lower - sine * upper;
    }
  }
  residual_square_ = residual_square_ + rest[unknowns_] * rest[unknowns_];
}

Scaled TriangularFactor::column_norm(int column) const {
  Scaled sum;
  for (int i = 0; i <= column; ++i) sum = sum + factor_[i][column] * factor_[i][column];
  return sqrt(sum);
}

bool TriangularFactor::determined(int column) const {
  return !factor_[column][column].is_zero() &&
         abs(factor_[column][column]) > scale_by_power_of_two(column_norm(column), -36);
}

void TriangularFactor::solve(Scaled* parameters) const {
  for (int k = unknowns_ - 1; k >= 0; --k) {
    parameters[k] = Scaled{};
    if (!determined(k)) continue;
    Scaled sum = factor_[k][unknowns_];
    for (int j = k + 1; j < unknowns_; ++j) sum = sum - factor_[k][j] * parameters[j];
    parameters[k] = sum / factor_[k][k];
  }
}

void TriangularFactor::invert() {
  for (int column = 0; column < unknowns_; ++column) {
    for (int row = 0; row < unknowns_; ++row) inverse_[row][column] = Scaled{};
    if (!determined(column)) continue;
    inverse_[column][column] = Scaled::from_int(1) / factor_[column][column];
    for (int row = column - 1; row >= 0; --row) {
      if (!determined(row)) continue;
      Scaled sum;
      for (int j = row + 1; j <= column; ++j) sum = sum - factor_[row][j] * inverse_[j][column];
      inverse_[row][column] = sum / factor_[row][row];
    }
  }
}

void TriangularFactor::apply_covariance(const Scaled* vector, Scaled* result) const {
  Scaled middle[kMaxUnknowns];
  for (int j = 0; j < unknowns_; ++j) {
    middle[j] = Scaled{};
    for (int i = 0; i <= j; ++i) middle[j] = middle[j] + inverse_[i][j] * vector[i];
  }
  for (int i = 0; i < unknowns_; ++i) {
    result[i] = Scaled{};
    for (int j = i; j < unknowns_; ++j) result[i] = result[i] + inverse_[i][j] * middle[j];
  }
}

Scaled TriangularFactor::covariance(int row, int column) const {
  Scaled sum;
  for (int j = row > column ? row : column; j < unknowns_; ++j) sum = sum + inverse_[row][j] * inverse_[column][j];
  return sum;
}

}  // namespace firmware
