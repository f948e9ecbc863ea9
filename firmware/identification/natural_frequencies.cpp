#include "firmware/identification/natural_frequencies.hpp"

namespace firmware {
namespace {

constexpr int kSweeps = 12;  // Jacobi converges quadratically; 16 by 16 needs about 6
using Matrix = Scaled[kMaxDofs][kMaxDofs];

bool assemble(const CoreConfiguration& configuration, const Estimates& estimates, Matrix& matrix) {
  const int n = configuration.dof_count;
  Scaled mass[kMaxDofs];
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) matrix[i][j] = Scaled{};
  for (int t = 0; t < configuration.term_count; ++t) {
    const Term& term = configuration.terms[t];
    const Scaled value = term.unknown < 0 ? term.value : estimates.parameters[term.unknown].value;
    if (term.kind == TermKind::kMass) mass[term.place] = value;
    if (term.kind != TermKind::kStiffness && term.kind != TermKind::kGravity) continue;
    const int a = configuration.links[term.place].node_a, b = configuration.links[term.place].node_b;
    if (a < n) matrix[a][a] = matrix[a][a] + value;
    if (b < n) matrix[b][b] = matrix[b][b] + value;
    if (a >= n || b >= n) continue;
    matrix[a][b] = matrix[a][b] - value;
    matrix[b][a] = matrix[b][a] - value;
  }
  for (int i = 0; i < n; ++i)
    if (mass[i] <= Scaled{}) return false;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) matrix[i][j] = matrix[i][j] / sqrt(mass[i] * mass[j]);
  return true;
}

void rotate(Matrix& matrix, int n, int p, int q) {
  if (matrix[p][q].is_zero()) return;
  // tan of the angle: t = sgn(h) / (|h| + sqrt(h^2 + 1)), h = (a_qq - a_pp) / (2 a_pq)
  const Scaled one = Scaled::from_int(1);
  const Scaled half = scale_by_power_of_two((matrix[q][q] - matrix[p][p]) / matrix[p][q], -1);
  Scaled tangent = one / (abs(half) + sqrt(half * half + one));
  if (half.is_negative()) tangent = -tangent;
  const Scaled cosine = one / sqrt(tangent * tangent + one), sine = tangent * cosine;
  for (int k = 0; k < n; ++k) {
    const Scaled left = matrix[k][p], right = matrix[k][q];
    matrix[k][p] = cosine * left - sine * right;
    matrix[k][q] = sine * left + cosine * right;
  }
  for (int k = 0; k < n; ++k) {
    const Scaled left = matrix[p][k], right = matrix[q][k];
    matrix[p][k] = cosine * left - sine * right;
    matrix[q][k] = sine * left + cosine * right;
  }
}

}  // namespace

bool natural_frequencies_Hz(const CoreConfiguration& configuration, const Estimates& estimates, Scaled* frequencies) {
  Matrix matrix;
  if (!assemble(configuration, estimates, matrix)) return false;
  const int n = configuration.dof_count;
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (int p = 0; p < n; ++p)
      for (int q = p + 1; q < n; ++q) rotate(matrix, n, p, q);
  for (int i = 0; i < n; ++i) frequencies[i] = sqrt(matrix[i][i]) / Scaled::ratio(710, 113);  // 2 pi to 8e-8
  return true;
}

}  // namespace firmware
