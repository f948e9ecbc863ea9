#include "firmware/identification/intervals/regressor_noise.hpp"

namespace firmware {
namespace {

constexpr int kTurns = 16;  // of the shift that its own shift adds to
// Times the value: a deviation of what noise may have taken to any part of itself.
constexpr int kNothingKnownLog2 = 6;

bool is_in(uint64_t set, int k) { return (set >> k & 1) != 0; }
static_assert(kMaxUnknowns <= 64, "a bit for each unknown");

// Adds share_k / p_k^2 of one row, whose right-hand side is its residual, at that residual; weight: of its square.
void add_row(const EquationList& list, const Row& row, const Scaled* p, const Scaled& weight, Scaled* variance) {
  Scaled energy, right_side = row.rhs;
  for (int k = 0; k < list.unknown_count; ++k) {
    const Scaled term = row.column[k] * p[k];
    multiply_add(energy, term, term);
    right_side += term;
  }
  multiply_add(energy, right_side, right_side);
  if (energy.is_zero()) return;
  const Scaled noise = row.rhs * row.rhs / energy * weight;
  for (int k = 0; k < list.unknown_count; ++k)
    if (!row.column[k].is_zero()) multiply_add(variance[k], row.column[k] * row.column[k], noise);
}

[[gnu::noinline]] void add_equation(const EquationList& list, const LevelColumns& level, const Whitening& whitening,
                                    int e, WeightedFit& fit, Scaled* variance) {
  if (whitening.deviation.is_zero()) return;
  Row row;
  if (level.periodic()) {
    if (whitened_level_row(list, level, whitening, e, row)) add_row(list, row, fit.parameters(), kScaledOne, variance);
    return;
  }
  const ReducedRows& rows = fit.reduce(whitening, e, true);
  const Scaled weight = kScaledOne / (whitening.deviation * whitening.deviation);
  for (int b = 0; b < level.batch_count(); ++b) {
    if (!level.row_used(b, list.equation[e].dof)) continue;
    rows.read(b, list.unknown_count, row);
    add_row(list, row, fit.parameters(), weight, variance);
  }
}

// Turns of shift = covariance V (p + shift), where a parameter of which nothing is known stays as it is. False: what a turn adds
// still grows.
// This and add_equation() have frames of their own: their vectors stand on the stack at different times.
[[gnu::noinline]] bool settles(const EquationList& list, const WeightedFit& fit, const Scaled* variance,
                               uint64_t nothing_known, Scaled* shift) {
  Scaled added[kMaxUnknowns];
  bool grows = false;
  for (int turn = 0; turn < kTurns; ++turn) {
    Scaled pull[kMaxUnknowns], next[kMaxUnknowns];
    for (int k = 0; k < list.unknown_count; ++k) pull[k] = variance[k] * (fit.parameters()[k] + shift[k]);
    fit.equations().apply_covariance(pull, next);
    bool settled = true;
    grows = false;
    for (int k = 0; k < list.unknown_count; ++k) {
      if (is_in(nothing_known, k)) continue;
      const Scaled adds = abs(next[k] - shift[k]);
      settled = settled && scale_by_power_of_two(adds, 4) <= abs(next[k]);
      grows = grows || (turn > 0 && adds > added[k]);
      added[k] = adds;
      shift[k] = next[k];
    }
    if (settled) return true;
  }
  return !grows;
}

// Of those that are not in the set, the one that its shift changes most. -1: none is left.
int most_shifted(const EquationList& list, const WeightedFit& fit, const Scaled* shift, uint64_t set) {
  int most = -1;
  for (int k = 0; k < list.unknown_count; ++k) {
    if (is_in(set, k)) continue;
    const Scaled* const p = fit.parameters();
    if (most < 0 || abs(shift[k] * p[most]) > abs(shift[most] * p[k])) most = k;
  }
  return most;
}

// The shift that is left of p + shift. It converges where what noise has added to the normal equations is less than what is there;
// else the rows are noise, or what stands in their residuals is none. The parameter that runs away fastest may then be anything, and what
// it takes the others along by is part of their shift: they may be known well beside it.
uint64_t find_shift(const EquationList& list, const WeightedFit& fit, const Scaled* variance, Scaled* shift) {
  uint64_t nothing_known = 0;
  while (!settles(list, fit, variance, nothing_known, shift)) {
    const int k = most_shifted(list, fit, shift, nothing_known);
    if (k < 0) break;
    nothing_known |= uint64_t{1} << k;
    for (int j = 0; j < list.unknown_count; ++j)
      shift[j] = is_in(nothing_known, j) ? scale_by_power_of_two(fit.parameters()[j], kNothingKnownLog2) : Scaled{};
  }
  return nothing_known;
}

}  // namespace

uint64_t take_out_regressor_noise(const EquationList& list, const BatchTable& table, WeightedFit& fit,
                                  Estimates& estimates) {
  if (!kHasDisplacementRows || !list.displacement) return 0;
  Scaled shift[kMaxUnknowns];
  Scaled* const variance = fit.vector();
  for (int k = 0; k < list.unknown_count; ++k) variance[k] = Scaled{};
  for (int l = 0; l < table.level_count; ++l) {
    const LevelColumns& level = fit.load_level(l);
    for (int e = 0; e < list.count; ++e) add_equation(list, level, fit.whitening(l, e), e, fit, variance);
  }
  const uint64_t nothing_known = find_shift(list, fit, variance, shift);
  for (int k = 0; k < list.unknown_count; ++k) {
    ParameterEstimate& parameter = estimates.parameters[k];
    if (scale_by_power_of_two(abs(shift[k]), 2) < parameter.std) continue;  // less than 3 % of the interval
    if (nothing_known == 0) {  // which way what is not known takes the others is not known
      parameter.value += shift[k];
      parameter.ci95_low += shift[k];
      parameter.ci95_high += shift[k];
    }
    widen(parameter, shift[k]);
  }
  return nothing_known;
}

}  // namespace firmware
