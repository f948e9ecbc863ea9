#include "firmware/identification/uncertainty.hpp"

#include "firmware/identification/student_quantile.hpp"

namespace firmware {
namespace {

// Rounding of codes and interpolation inside a sample repeat with every cycle and do not show in any scatter: 1e-6 of the
// value, the largest such error of the clean scenarios (docs/accuracy.md), is part of every deviation.
constexpr int kRepeatedErrorLog2 = -20;
constexpr int kLeastLevels = 3;  // that show a scatter of their own

struct Sums {
  Scaled variance[kMaxUnknowns];
  Scaled variance_square_per_freedom[kMaxUnknowns];
  // Of one level: what its residuals pull the parameter by, and the variance of that; over all levels: sum of pull squares.
  Scaled pull[kMaxUnknowns], pull_square[kMaxUnknowns];
  Scaled relative_residuals;
  uint32_t rows = 0;
  uint32_t relative_rows = 0;
};

// Adds what one equation of one level contributes.
// A frame of its own: its vectors and the sums of the caller together would be a third more than any other function has.
[[gnu::noinline]] void add_equation(const EquationList& list, const LevelObservables& level, const Whitening& whitening,
                                    int e, const WeightedFit& fit, Sums& sums) {
  Scaled share[kMaxUnknowns], gain[kMaxUnknowns];
  const int first = level.periodic() ? -1 : 0, last = level.periodic() ? 0 : level.batch_count();
  Row row;
  int rows = 0;
  for (int b = first; b < last; ++b) {
    if (!whitened_row(list, level, whitening, e, b, row)) continue;
    ++rows;
    fit.factor().apply_covariance(row.column, gain);
    for (int k = 0; k < list.unknown_count; ++k) share[k] = share[k] + gain[k] * gain[k];
    Scaled residual = row.rhs;
    for (int k = 0; k < list.unknown_count; ++k) residual = residual - row.column[k] * fit.parameters()[k];
    for (int k = 0; k < list.unknown_count; ++k) sums.pull[k] = sums.pull[k] + gain[k] * residual;
    if (!row.rhs.is_zero()) {
      sums.relative_residuals = sums.relative_residuals + abs(residual / row.rhs);
      ++sums.relative_rows;
    }
  }
  sums.rows += static_cast<uint32_t>(rows);
  const Scaled freedom = Scaled::from_int(whitening.freedom > 0 ? whitening.freedom : 1);
  for (int k = 0; k < list.unknown_count; ++k) {
    const Scaled part = share[k] * whitening.inflation;
    sums.variance[k] = sums.variance[k] + part;
    sums.variance_square_per_freedom[k] = sums.variance_square_per_freedom[k] + part * part / freedom;
  }
}

// Residual scatter lost to the fitted parameters, and a fit that misses its own weights by far: both widen the
// intervals.
Scaled variance_factor(const EquationList& list, const WeightedFit& fit, uint32_t rows, bool periodic) {
  const int freedom = static_cast<int>(rows) - list.unknown_count;
  if (freedom <= 0) return Scaled::from_int(1);
  const Scaled misfit = fit.factor().residual_square() / Scaled::from_int(freedom);
  if (!fit.all_measured()) return misfit;
  const Scaled lost = periodic ? Scaled::from_int(1) : Scaled::ratio(static_cast<int64_t>(rows), freedom);
  // Chance takes the misfit over 1 + 5 sqrt(2 / freedom) less than once in 10^4 fits.
  const Scaled limit = Scaled::from_int(1) + sqrt(Scaled::ratio(50, freedom)) + Scaled::ratio(6, freedom);
  return misfit > limit ? (misfit > lost ? misfit : lost) : lost;
}

void report(const EquationList& list, const WeightedFit& fit, const Sums& sums, Scaled factor, bool measured,
            Estimates& estimates) {
  const int spare = static_cast<int>(sums.rows) - list.unknown_count;
  for (int k = 0; k < list.unknown_count; ++k) {
    ParameterEstimate& parameter = estimates.parameters[k];
    parameter.value = fit.parameters()[k];
    const Scaled variance = sums.variance[k];
    const Scaled repeated = scale_by_power_of_two(parameter.value, kRepeatedErrorLog2);
    parameter.std = sqrt(variance * factor + repeated * repeated);
    Scaled freedom = Scaled::from_int(spare > 0 ? spare : 1);
    if (measured && !sums.variance_square_per_freedom[k].is_zero())
      freedom = variance * variance / sums.variance_square_per_freedom[k];
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
void add_scatter_between_levels(const EquationList& list, int levels, Sums& sums) {
  const Scaled freedom = Scaled::from_int(levels - 1);
  const Scaled limit = Scaled::from_int(1) + Scaled::ratio(44, 10) / sqrt(freedom) + Scaled::ratio(62, 10) / freedom;
  for (int k = 0; k < list.unknown_count; ++k) {
    const Scaled between = sums.pull_square[k] * Scaled::ratio(levels, levels - 1);
    if (between <= sums.variance[k] * limit) continue;
    sums.variance[k] = between;
    sums.variance_square_per_freedom[k] = between * between / freedom;
  }
}

}  // namespace

void estimate_uncertainty(const EquationList& list, const BatchTable& table, WeightedFit& fit, Estimates& estimates) {
  Sums sums;
  bool periodic = true;
  int levels = 0;
  for (int l = 0; l < table.level_count; ++l) {
    const LevelObservables& level = fit.load_level(l);
    periodic = periodic && level.periodic();
    for (int e = 0; e < list.count; ++e) add_equation(list, level, fit.whitening(l, e), e, fit, sums);
    for (int k = 0; k < list.unknown_count; ++k) {
      sums.pull_square[k] = sums.pull_square[k] + sums.pull[k] * sums.pull[k];
      sums.pull[k] = Scaled{};
    }
    if (level.batch_count() > 0) ++levels;
  }
  if (levels >= kLeastLevels && !periodic) add_scatter_between_levels(list, levels, sums);
  report(list, fit, sums, variance_factor(list, fit, sums.rows, periodic), fit.all_measured(), estimates);
}

}  // namespace firmware
