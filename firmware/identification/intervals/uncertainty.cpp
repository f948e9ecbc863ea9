#include "firmware/identification/intervals/uncertainty.hpp"

#include "firmware/identification/intervals/student_quantile.hpp"

namespace firmware {
namespace {

// Rounding of codes and interpolation inside a sample repeat with every cycle and do not show in any scatter: 1e-6 of the
// value, the largest such error of the clean scenarios (docs/accuracy.md), is part of every deviation.
constexpr int kRepeatedErrorLog2 = -20;

void add_share(const Scaled& part, const Scaled& freedom, int k, UncertaintySums& sums) {
  sums.variance(k) += part;
  sums.variance_per_freedom(k) += part / freedom;
  sums.variance_square_per_freedom(k) += part * part / freedom;
}

void add_relative(const Scaled& residual, const Scaled& right_side, UncertaintySums& sums) {
  if (right_side.is_zero()) return;
  sums.relative_residuals += abs(residual / right_side);
  ++sums.relative_rows;
}

// Of a periodic level: one row, its right-hand side the residual; what the parameters explain comes to it. This and add_rows() have
// frames of their own: their vectors stand on the stack at different times.
[[gnu::noinline]] void add_level_row(const EquationList& list, const LevelColumns& level, const Whitening& whitening,
                                     int e, const WeightedFit& fit, UncertaintySums& sums) {
  Row row;
  if (!whitened_level_row(list, level, whitening, e, row)) return;
  Scaled gain[kMaxUnknowns], right_side = row.rhs;
  const Scaled freedom = Scaled::from_int(whitening.freedom > 0 ? whitening.freedom : 1);
  fit.equations().apply_covariance(row.column, gain);
  for (int k = 0; k < list.unknown_count; ++k) {
    multiply_add(right_side, row.column[k], fit.parameters()[k]);
    if (UncertaintySums::kPulls) multiply_add(sums.pull[k], gain[k], row.rhs);
    add_share(gain[k] * gain[k] * whitening.inflation, freedom, k, sums);
  }
  add_relative(row.rhs, right_side, sums);
  ++sums.rows;
}

// The gain of parameter k: column k of the covariance times the rows. What the fit takes out of the residuals of these rows
// is the trace of their hat matrix: so many degrees of freedom less have they, and so much larger is their variance.
[[gnu::noinline]] void add_rows(WeightedFit& fit, const Whitening& whitening, ReducedRows& rows, int batches,
                                int unknowns, UncertaintySums& sums) {
  const Scaled weight = whitening.weight();
  Scaled factor[kMaxUnknowns], fitted;
  Scaled* const share = fit.vector();
  for (int k = 0; k < unknowns; ++k) {
    for (int j = 0; j < rows.unknowns; ++j) factor[j] = fit.equations().covariance(k, rows.unknown[j]);
    const WholeColumn gain = rows.combine(factor, batches);
    share[k] = dot(gain, gain, batches) * weight;
    for (int j = 0; j < rows.unknowns; ++j)
      if (rows.unknown[j] == k) multiply_add(fitted, dot(gain, rows.column(j), batches), weight);
    if (UncertaintySums::kPulls) multiply_add(sums.pull[k], dot(gain, rows.residual(), batches), weight);
  }
  const Scaled before = Scaled::from_int(whitening.freedom > 0 ? whitening.freedom : 1), least = kScaledOne;
  const Scaled freedom = before < fitted + least ? least : before - fitted;
  for (int k = 0; k < unknowns; ++k) add_share(share[k] * whitening.inflation * (before / freedom), freedom, k, sums);
  for (int j = 0; j < rows.unknowns; ++j) factor[j] = fit.parameters()[rows.unknown[j]];
  const WholeColumn explained = rows.combine(factor, batches), left = rows.residual();
  for (int b = 0; b < batches; ++b) {
    const Scaled residual = Scaled::from_int(left.value[b], left.exponent);
    add_relative(residual, residual + Scaled::from_int(explained.value[b], explained.exponent), sums);
  }
  sums.rows += static_cast<uint32_t>(rows.rows);
}

// Adds what one equation of one level contributes.
void add_equation(const EquationList& list, const LevelColumns& level, const Whitening& whitening, int e,
                  WeightedFit& fit, UncertaintySums& sums) {
  if (whitening.deviation.is_zero()) return;
  if (level.periodic()) return add_level_row(list, level, whitening, e, fit, sums);
  add_rows(fit, whitening, fit.reduce(whitening, e, true), level.batch_count(), list.unknown_count, sums);
}

// A fit that misses its own weights by far widens the intervals.
Scaled variance_factor(const EquationList& list, const WeightedFit& fit, uint32_t rows) {
  const int freedom = static_cast<int>(rows) - list.unknown_count;
  if (freedom <= 0) return kScaledOne;
  const Scaled misfit = fit.equations().residual_square() / freedom;
  if (!fit.all_measured()) return misfit;
  // Chance takes the misfit over 1 + 5 sqrt(2 / freedom) less than once in 10^4 fits.
  const Scaled limit = kScaledOne + sqrt(Scaled::ratio(50, freedom)) + Scaled::ratio(6, freedom);
  return misfit > limit ? misfit : kScaledOne;
}

void report(const EquationList& list, const WeightedFit& fit, UncertaintySums& sums, const Scaled& factor,
            bool measured) {
  Estimates& estimates = *sums.estimates;
  const int spare = static_cast<int>(sums.rows) - list.unknown_count;
  for (int k = 0; k < list.unknown_count; ++k) {
    ParameterEstimate& parameter = estimates.parameters[k];
    parameter.value = fit.parameters()[k];
    const Scaled variance = sums.variance(k);
    const Scaled repeated = scale_by_power_of_two(parameter.value, kRepeatedErrorLog2);
    Scaled of_weights = kScaledOne, freedom = Scaled::from_int(spare > 0 ? spare : 1);
    if (measured && !sums.variance_square_per_freedom(k).is_zero()) {
      freedom = variance * variance / sums.variance_square_per_freedom(k);
      const Scaled chosen = sums.variance_per_freedom(k) / variance - kScaledOne / freedom;
      if (chosen.is_positive()) of_weights += scale_by_power_of_two(chosen, 2);
    }
    // No variance: no row tells it.
    parameter.std = variance.is_zero() ? Scaled{} : sqrt(variance * factor * of_weights + repeated * repeated);
    const Scaled half = student_quantile_95(freedom) * parameter.std;
    parameter.ci95_low = parameter.value - half;
    parameter.ci95_high = parameter.value + half;
  }
  estimates.rows = sums.rows;
  estimates.residual_mean_abs =
      sums.relative_rows ? sums.relative_residuals / Scaled::from_int(static_cast<int64_t>(sums.relative_rows))
                         : Scaled{};
}

// A parameter that differs between levels (friction that warms up) shows no more scatter within any of them: the levels pull it
// apart. Where they pull by more than noise does once in 10^3 fits (chi-square over its freedom n stays below 1 + 4.4 / sqrt(n) +
// 6.2 / n, Wilson and Hilferty), the variance is theirs, with as many degrees of freedom as there are levels less one.
void add_scatter_between_levels(const EquationList& list, int levels, UncertaintySums& sums) {
  const Scaled freedom = Scaled::from_int(levels - 1);
  const Scaled limit = kScaledOne + Scaled::ratio(44, 10) / sqrt(freedom) + Scaled::ratio(62, 10) / freedom;
  for (int k = 0; k < list.unknown_count; ++k) {
    const Scaled between = sums.pull_square[k] * Scaled::ratio(levels, levels - 1);
    if (between <= sums.variance(k) * limit) continue;
    sums.variance(k) = between;
    sums.variance_per_freedom(k) = between / freedom;
    sums.variance_square_per_freedom(k) = between * between / freedom;
  }
}

}  // namespace

void begin_uncertainty(UncertaintySums& sums, Estimates& estimates) {
  sums.estimates = &estimates;
  for (int k = 0; k < kMaxUnknowns; ++k)
    sums.variance(k) = sums.variance_per_freedom(k) = sums.variance_square_per_freedom(k) = Scaled{};
  for (int k = 0; UncertaintySums::kPulls && k < kMaxUnknowns; ++k) sums.pull[k] = sums.pull_square[k] = Scaled{};
  sums.relative_residuals = Scaled{};
  sums.rows = sums.relative_rows = 0;
  sums.levels = 0;
  sums.periodic = true;
}

void add_uncertainty(const EquationList& list, const LevelColumns& level, int l, WeightedFit& fit,
                     UncertaintySums& sums) {
  sums.periodic = sums.periodic && level.periodic();
  for (int e = 0; e < list.count; ++e) add_equation(list, level, fit.whitening(l, e), e, fit, sums);
  for (int k = 0; UncertaintySums::kPulls && k < list.unknown_count; ++k) {
    multiply_add(sums.pull_square[k], sums.pull[k], sums.pull[k]);
    sums.pull[k] = Scaled{};
  }
  if (level.batch_count() > 0) ++sums.levels;
}

void report_uncertainty(const EquationList& list, const WeightedFit& fit, UncertaintySums& sums) {
  if (UncertaintySums::kPulls && sums.levels >= kLeastLevels && !sums.periodic)
    add_scatter_between_levels(list, sums.levels, sums);
  report(list, fit, sums, variance_factor(list, fit, sums.rows), fit.all_measured());
}

}  // namespace firmware
