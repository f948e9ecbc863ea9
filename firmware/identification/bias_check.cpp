#include "firmware/identification/bias_check.hpp"

namespace firmware {
namespace {

// Plain minus instrumented residual of a velocity equation in one batch, at the same parameters.
Scaled residual_change(const EquationList& list, const BatchTable& table, const Batch& batch, int e, const Scaled* p) {
  if (e >= list.dof_count) return {};
  const Equation plain = {list.equation[e].dof, Weight::kPlain};
  return batch_residual(table.layout, batch, plain, p) - batch_residual(table.layout, batch, list.equation[e], p);
}

Scaled whitened_change(const EquationList& list, const BatchTable& table, const LevelObservables& level,
                       const Whitening& whitening, const Batch& batch, int b, int e, const Scaled* p) {
  Scaled change = level.inverse_scale(b, list.equation[e].dof) * residual_change(list, table, batch, e, p);
  for (int j = 0; j < whitening.count; ++j) {
    if (whitening.observable[j] < kMaxControls) continue;
    const int other = whitening.observable[j] - kMaxControls;
    change = change - whitening.coefficient[j] * level.inverse_scale(b, list.equation[other].dof) *
                          residual_change(list, table, batch, other, p);
  }
  return change / whitening.deviation;
}

void add_equation(const EquationList& list, const BatchTable& table, const LevelObservables& level, int l, int e,
                  const WeightedFit& fit, Scaled (&shift)[kMaxBatches][kMaxUnknowns]) {
  const Whitening& whitening = fit.whitening(l, e);
  Row row;
  Scaled gain[kMaxUnknowns];
  bool usable = level.periodic() && whitened_row(list, level, whitening, e, -1, row);
  if (usable) fit.factor().apply_covariance(row.column, gain);
  for (int b = 0; b < level.batch_count(); ++b) {
    if (!level.periodic()) {
      usable = whitened_row(list, level, whitening, e, b, row);
      if (usable) fit.factor().apply_covariance(row.column, gain);
    }
    if (!usable) continue;
    const Scaled change =
        whitened_change(list, table, level, whitening, table.level[l].batch[b], b, e, fit.parameters());
    for (int k = 0; k < list.unknown_count; ++k) shift[b][k] = shift[b][k] + gain[k] * change;
  }
}

}  // namespace

void compare_with_plain(const EquationList& list, const BatchTable& table, WeightedFit& fit, BiasCheck& result) {
  for (int k = 0; k < kMaxUnknowns; ++k) result.difference[k] = result.deviation[k] = Scaled{};
  if (!list.instrument) return;
  Scaled variance[kMaxUnknowns];
  auto& shift = result.shift;
  for (int l = 0; l < table.level_count; ++l) {
    const LevelObservables& level = fit.load_level(l);
    const int n = level.batch_count();
    for (int b = 0; b < n; ++b)
      for (int k = 0; k < list.unknown_count; ++k) shift[b][k] = Scaled{};
    for (int e = 0; e < list.count; ++e) add_equation(list, table, level, l, e, fit, shift);
    for (int k = 0; k < list.unknown_count && n > 0; ++k) {
      Scaled sum, squares;
      for (int b = 0; b < n; ++b) sum = sum + shift[b][k];
      const Scaled mean = sum / Scaled::from_int(n);
      for (int b = 0; b < n; ++b) squares = squares + (shift[b][k] - mean) * (shift[b][k] - mean);
      result.difference[k] = result.difference[k] + sum;
      variance[k] = variance[k] + (n > 1 ? squares * Scaled::ratio(n, n - 1) : sum * sum);
    }
  }
  for (int k = 0; k < list.unknown_count; ++k) result.deviation[k] = sqrt(variance[k]);
}

bool bias_suspect(const BiasCheck& check, int unknown, const ParameterEstimate& parameter) {
  const Scaled difference = abs(check.difference[unknown]);
  return difference > check.deviation[unknown] * Scaled::from_int(3) &&
         scale_by_power_of_two(difference, 1) > parameter.ci95_high - parameter.ci95_low &&
         difference * Scaled::from_int(20) > abs(parameter.value);
}

}  // namespace firmware
