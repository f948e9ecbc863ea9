#include "firmware/identification/identification.hpp"

#include "firmware/identification/conditions/advice.hpp"
#include "firmware/identification/conditions/excitation_check.hpp"
#include "firmware/identification/conditions/few_codes.hpp"
#include "firmware/identification/conditions/open_scale.hpp"
#include "firmware/identification/conditions/skew.hpp"
#include "firmware/identification/conditions/slow_motion.hpp"
#include "firmware/identification/intervals/bias_check.hpp"
#include "firmware/identification/intervals/noise_doubt.hpp"
#include "firmware/identification/intervals/regressor_noise.hpp"

namespace firmware {
namespace {

bool any_saturated(const BatchTable& table) {
  for (int l = 0; l < table.level_count; ++l)
    if (table.level[l].saturated) return true;
  return false;
}

int rows_of(const EquationList& list, const BatchTable& table, int unknown) {
  int rows = 0;
  for (int e = 0; e < list.count; ++e) {
    const int dof = list.equation[e].dof;
    if (!stands_in(table.layout, dof, unknown)) continue;
    for (int l = 0; l < table.level_count; ++l) rows += table.level[l].periodic ? 1 : table.level[l].batch_count;
  }
  return rows;
}

// Noise in the columns of a parameter's rows is part of what is left of the rows. So it bends the parameter p of deviation s by at most
// rows s^2 / p.
bool bent_by_columns(const EquationList& list, const BatchTable& table, const ParameterEstimate& parameter,
                     int unknown) {
  const Scaled bend = parameter.std * kLargestNoiseShare;
  return bend * bend * rows_of(list, table, unknown) > parameter.value * parameter.value;
}

bool inseparable(const WeightedFit& fit, const EquationList& list, const BatchTable& table, const Estimates& estimates,
                 int unknown) {
  const Scaled& inflation = fit.identifiability().inflation[unknown];
  const ParameterEstimate& parameter = estimates.parameters[unknown];
  if (estimates.rows < estimates.unknown_count || inflation.is_zero() || parameter.std.is_zero() ||
      inflation > Scaled::from_int(kLargestInflation))
    return true;
  return inflation * fit.relative_noise() * kLargestNoiseShare > kScaledOne &&
         bent_by_columns(list, table, parameter, unknown);
}

// Where some parameters cannot be told apart, an uncertain one beside them is not believed either.
bool inseparable_company(const WeightedFit& fit, const EquationList& list, const BatchTable& table,
                         const Estimates& estimates, int unknown) {
  const ParameterEstimate& parameter = estimates.parameters[unknown];
  if (exceeds(parameter.value, parameter.std * 10)) return false;
  for (int k = 0; k < estimates.unknown_count; ++k)
    if (inseparable(fit, list, table, estimates, k)) return true;
  return false;
}

bool not_told_apart(const WeightedFit& fit, const EquationList& list, const BatchTable& table,
                    const Estimates& estimates, int unknown) {
  return inseparable(fit, list, table, estimates, unknown) || inseparable_company(fit, list, table, estimates, unknown);
}

// The gravest that applies. nothing_known: of those that noise may have taken to any part of themselves a bit each.
EstimateStatus judge(const IdentificationMemory& memory, const EquationList& list, const BatchTable& table,
                     const CoreConfiguration& configuration, int unknown, const Estimates& estimates,
                     uint64_t nothing_known) {
  const WeightedFit& fit = memory.fit;
  if (any_saturated(table)) return EstimateStatus::kSaturated;
  if (!is_excited(list, table, configuration, unknown)) return EstimateStatus::kNoExcitation;
  if ((nothing_known >> unknown & 1) != 0 || not_told_apart(fit, list, table, estimates, unknown) ||
      filters_alone_move(table, configuration, unknown) ||
      is_undetermined(list, table, configuration, unknown, estimates))
    return EstimateStatus::kIllConditioned;
  if (skew_matters(list, table, configuration, unknown, estimates)) return EstimateStatus::kSkewed;
  if (bias_suspect(memory.bias, unknown, estimates.parameters[unknown]) || has_few_codes(table, configuration, unknown))
    return EstimateStatus::kBiasSuspect;
  return EstimateStatus::kValid;
}

}  // namespace

bool any_batch(const BatchTable& table) {
  for (int l = 0; l < table.level_count; ++l)
    if (table.level[l].batch_count > 0) return true;
  return false;
}

void identify(const CoreConfiguration& configuration, const BatchTable& table, IdentificationMemory& memory,
              Estimates& estimates) {
  WeightedFit& fit = memory.fit;
  BiasCheck& bias = memory.bias;
  const uint32_t windows = estimates.window_counter;
  clear(estimates);
  estimates.unknown_count = configuration.unknown_count;
  estimates.window_counter = windows;
  if (!any_batch(table)) return;  // every status stays STALE
  ++estimates.window_counter;
  const EquationList list = list_equations(configuration, table);
  fit.solve(list, table);
  begin_uncertainty(memory.sums, estimates);
  begin_comparison(bias);
  for (int l = 0; l < table.level_count; ++l) {
    LevelColumns& level = fit.load_level(l);
    add_uncertainty(list, level, l, fit, memory.sums);
    compare_with_plain(list, level, l, fit, bias);
  }
  report_uncertainty(list, fit, memory.sums);
  add_noise_doubt(configuration, list, table, fit, estimates);
  const uint64_t nothing_known = kWeights < 3 ? 0 : take_out_regressor_noise(list, table, fit, estimates);
  end_comparison(list, bias);
  estimates.condition_number = fit.identifiability().condition_number;
  measure_skew(list, table, configuration, estimates);
  for (int k = 0; k < list.unknown_count; ++k) {
    ParameterEstimate& parameter = estimates.parameters[k];
    parameter.variance_inflation = fit.identifiability().inflation[k];
    parameter.plain_value = parameter.value + bias.difference[k];
    parameter.status = judge(memory, list, table, configuration, k, estimates, nothing_known);
    if (parameter.status == EstimateStatus::kIllConditioned && not_told_apart(fit, list, table, estimates, k))
      estimates.inseparable = true;
    estimates.unresolved[k] = fit.identifiability().unresolved[k];
  }
  if (kHasDisplacementRows) doubt_beside_open_scale(configuration, list, estimates);  // else no mass is estimated
  give_advice(list, table, configuration, estimates);
}

}  // namespace firmware
