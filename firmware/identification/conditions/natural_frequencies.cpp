#include "firmware/identification/conditions/natural_frequencies.hpp"

namespace firmware {
namespace {

constexpr int kSweeps = 12;  // Jacobi converges quadratically; 16 by 16 needs about 6

// A symmetric matrix, its lower triangle alone: half the stack of a full one.
class SymmetricMatrix {
 public:
  Scaled& at(int i, int j) { return i >= j ? entry_[i * (i + 1) / 2 + j] : entry_[j * (j + 1) / 2 + i]; }

 private:
  Scaled entry_[kMaxDofs * (kMaxDofs + 1) / 2] = {};
};

// mass: room for one of each DOF.
bool assemble(const CoreConfiguration& configuration, const Estimates& estimates, Scaled* mass,
              SymmetricMatrix& matrix) {
  const int n = configuration.dof_count;
  for (int i = 0; i < n; ++i) mass[i] = Scaled{};
  for (int t = 0; t < configuration.term_count; ++t) {
    const Term& term = configuration.terms[t];
    const Scaled& value = term.unknown < 0 ? term.value : estimates.parameters[term.unknown].value;
    if (term.kind == TermKind::kMass) mass[term.place] = value;
    if (term.kind != TermKind::kStiffness && term.kind != TermKind::kGravity) continue;
    const int a = configuration.links[term.place].node_a, b = configuration.links[term.place].node_b;
    if (a < n) matrix.at(a, a) += value;
    if (b < n) matrix.at(b, b) += value;
    if (a < n && b < n) matrix.at(a, b) -= value;
  }
  for (int i = 0; i < n; ++i)
    if (!mass[i].is_positive()) return false;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j) matrix.at(i, j) = matrix.at(i, j) / sqrt(mass[i] * mass[j]);
  return true;
}

// Makes a_pq zero: a_pp - t a_pq, a_qq + t a_pq, and each other row's two entries turned by the angle with tangent t.
void rotate(SymmetricMatrix& matrix, int n, int p, int q) {
  const Scaled& coupling = matrix.at(p, q);
  if (coupling.is_zero()) return;
  // t = sgn(h) / (|h| + sqrt(h^2 + 1)), h = (a_qq - a_pp) / (2 a_pq)
  const Scaled half = scale_by_power_of_two((matrix.at(q, q) - matrix.at(p, p)) / coupling, -1);
  Scaled tangent = kScaledOne / (abs(half) + sqrt(half * half + kScaledOne));
  if (half.is_negative()) tangent = -tangent;
  const Scaled cosine = kScaledOne / sqrt(tangent * tangent + kScaledOne), sine = tangent * cosine;
  const Scaled turned = tangent * coupling;
  matrix.at(p, p) -= turned;
  matrix.at(q, q) += turned;
  matrix.at(p, q) = Scaled{};
  for (int k = 0; k < n; ++k) {
    if (k == p || k == q) continue;
    Scaled &left = matrix.at(k, p), &right = matrix.at(k, q);
    const Scaled before = left;
    left = cosine * before - sine * right;
    right = sine * before + cosine * right;
  }
}

}  // namespace

bool natural_frequencies_Hz(const CoreConfiguration& configuration, const Estimates& estimates, Scaled* frequencies) {
  SymmetricMatrix matrix;
  if (!assemble(configuration, estimates, frequencies, matrix)) return false;
  const int n = configuration.dof_count;
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (int p = 0; p < n; ++p)
      for (int q = p + 1; q < n; ++q) rotate(matrix, n, p, q);
  for (int i = 0; i < n; ++i) frequencies[i] = sqrt(matrix.at(i, i)) / Scaled::ratio(710, 113);  // 2 pi to 8e-8
  return true;
}

}  // namespace firmware
