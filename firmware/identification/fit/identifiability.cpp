#include "firmware/identification/fit/identifiability.hpp"

namespace firmware {
namespace {

constexpr int kIterations =
    40;  // of the power method; the ratio converges with the square of the gap between singular values

// vector divided by its norm; returns the norm.
Scaled normalise(Scaled* vector, int size) {
  Scaled sum;
  for (int k = 0; k < size; ++k) multiply_add(sum, vector[k], vector[k]);
  const Scaled norm = sqrt(sum);
  if (norm.is_zero()) return norm;
  const Scaled inverse = kScaledOne / norm;
  for (int k = 0; k < size; ++k) vector[k] *= inverse;
  return norm;
}

void start_vector(const NormalEquations& factor, Scaled* vector) {
  for (int k = 0; k < factor.unknowns(); ++k)
    vector[k] =
        factor.determined(k) ? Scaled::from_int(1 + (k * 7) % 5) : Scaled{};  // not orthogonal to anything likely
}

// Largest singular value of R D^-1, D the column norms, and its right singular vector.
[[gnu::noinline]] Scaled largest_singular_value(const NormalEquations& factor, const Scaled* norm, Scaled* vector) {
  const int n = factor.unknowns();
  Scaled middle[kMaxUnknowns], inverse[kMaxUnknowns], square;
  for (int j = 0; j < n; ++j)
    if (!norm[j].is_zero()) inverse[j] = kScaledOne / norm[j];
  start_vector(factor, vector);
  normalise(vector, n);
  for (int turn = 0; turn < kIterations; ++turn) {
    for (int j = 0; j < n; ++j) vector[j] *= inverse[j];
    for (int i = 0; i < n; ++i) {
      middle[i] = Scaled{};
      for (int j = i; j < n; ++j) multiply_add(middle[i], factor.factor(i, j), vector[j]);
    }
    for (int j = 0; j < n; ++j) {
      vector[j] = Scaled{};
      for (int i = 0; i <= j; ++i) multiply_add(vector[j], factor.factor(i, j), middle[i]);
      vector[j] *= inverse[j];
    }
    square = normalise(vector, n);
  }
  return sqrt(square);
}

// Smallest singular value of R D^-1 and its right singular vector, by inverse iteration.
[[gnu::noinline]] Scaled smallest_singular_value(const NormalEquations& factor, const Scaled* norm, Scaled* vector) {
  const int n = factor.unknowns();
  Scaled scaled[kMaxUnknowns], square;
  start_vector(factor, vector);
  normalise(vector, n);
  for (int turn = 0; turn < kIterations; ++turn) {
    for (int k = 0; k < n; ++k) scaled[k] = vector[k] * norm[k];
    factor.apply_covariance(scaled, vector);
    for (int k = 0; k < n; ++k) vector[k] *= norm[k];
    square = normalise(vector, n);
  }
  return square.is_zero() ? square : kScaledOne / sqrt(square);
}

// A column that those before it make up is left out, its parameter taken for zero: whatever it is goes into theirs, however well they are
// determined without it. Those that make up a hundredth of it, and with it those a hundredth of which it bends, are not told apart.
[[gnu::noinline]] void entangle_with(const NormalEquations& factor, const Scaled* norm, int left_out,
                                     Scaled* inflation) {
  Scaled share[kMaxUnknowns];
  factor.combine(left_out, share);
  for (int i = 0; i < left_out; ++i)
    if (abs(share[i]) * norm[i] * kLargestInflation > norm[left_out]) inflation[i] = Scaled{};
}

}  // namespace

void judge_identifiability(NormalEquations& factor, const Scaled* parameters, Identifiability& result) {
  const int n = factor.unknowns();
  Scaled norm[kMaxUnknowns];
  factor.invert();
  bool all_determined = n > 0;
  for (int k = 0; k < n; ++k) {
    norm[k] = factor.column_norm(k);
    all_determined = all_determined && factor.determined(k);
    result.inflation[k] = factor.determined(k) ? sqrt(factor.covariance(k, k)) * norm[k] : Scaled{};
  }
  for (int k = 0; k < n; ++k)
    if (!factor.determined(k) && !norm[k].is_zero()) entangle_with(factor, norm, k, result.inflation);
  const Scaled largest = largest_singular_value(factor, norm, result.unresolved);
  const Scaled smallest = smallest_singular_value(factor, norm, result.unresolved);
  result.condition_number = all_determined ? largest / smallest : power_of_two(40);

  Scaled top;
  for (int k = 0; k < n; ++k) {
    Scaled& entry = result.unresolved[k];
    if (norm[k].is_zero() || parameters[k].is_zero()) entry = Scaled{};
    if (!entry.is_zero()) entry /= norm[k] * abs(parameters[k]);
    if (exceeds(entry, top)) top = entry;
  }
  for (int k = 0; k < n; ++k)
    if (!top.is_zero()) result.unresolved[k] /= top;
}

}  // namespace firmware
