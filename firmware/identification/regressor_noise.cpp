#include "firmware/identification/regressor_noise.hpp"

namespace firmware {
namespace {

// Adds share_k / p_k of one row, at its own whitened residual.
void add_row(const EquationList& list, const Row& row, const Scaled* p, Scaled* pull) {
  Scaled energy = row.rhs * row.rhs, residual = row.rhs;
  for (int k = 0; k < list.unknown_count; ++k) {
    const Scaled term = row.column[k] * p[k];
    energy = energy + term * term;
    residual = residual - term;
  }
  if (energy.is_zero()) return;
  const Scaled noise = residual * residual / energy;
  for (int k = 0; k < list.unknown_count; ++k)
    if (!row.column[k].is_zero()) pull[k] = pull[k] + row.column[k] * row.column[k] * p[k] * noise;
}

}  // namespace

void take_out_regressor_noise(const EquationList& list, const BatchTable& table, WeightedFit& fit,
                              Estimates& estimates) {
  if (!list.displacement) return;
  Scaled pull[kMaxUnknowns], shift[kMaxUnknowns];
  Row row;
  for (int l = 0; l < table.level_count; ++l) {
    const LevelObservables& level = fit.load_level(l);
    const int first = level.periodic() ? -1 : 0, last = level.periodic() ? 0 : level.batch_count();
    for (int e = 0; e < list.count; ++e)
      for (int b = first; b < last; ++b)
        if (whitened_row(list, level, fit.whitening(l, e), e, b, row)) add_row(list, row, fit.parameters(), pull);
  }
  fit.factor().apply_covariance(pull, shift);
  for (int k = 0; k < list.unknown_count; ++k) {
    ParameterEstimate& parameter = estimates.parameters[k];
    if (scale_by_power_of_two(abs(shift[k]), 2) < parameter.std) continue;  // less than 3 % of the interval
    parameter.value = parameter.value + shift[k];
    parameter.ci95_low = parameter.ci95_low + shift[k];
    parameter.ci95_high = parameter.ci95_high + shift[k];
    widen(parameter, shift[k]);
  }
}

}  // namespace firmware
