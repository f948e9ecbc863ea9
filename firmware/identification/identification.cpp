#include "firmware/identification/identification.hpp"

#include "firmware/identification/excitation_check.hpp"
#include "firmware/identification/uncertainty.hpp"

namespace firmware {
namespace {

WeightedFit fit;  // the stage's working memory

bool any_saturated(const BatchTable& table) {
  for (int l = 0; l < table.level_count; ++l)
    if (table.level[l].saturated) return true;
  return false;
}

bool any_batch(const BatchTable& table) {
  for (int l = 0; l < table.level_count; ++l)
    if (table.level[l].batch_count > 0) return true;
  return false;
}

// Saturation outweighs all, then a link at rest, then parameters that cannot be told apart.
EstimateStatus judge(const EquationList& list, const BatchTable& table, const CoreConfiguration& configuration,
                     int unknown, const Estimates& estimates) {
  if (any_saturated(table)) return EstimateStatus::kSaturated;
  if (!is_excited(list, table, configuration, unknown)) return EstimateStatus::kNoExcitation;
  const Scaled inflation = fit.identifiability().inflation[unknown];
  if (estimates.rows <= list.unknown_count || inflation.is_zero() || inflation > Scaled::from_int(kLargestInflation))
    return EstimateStatus::kIllConditioned;
  return EstimateStatus::kValid;
}

}  // namespace

void identify(const CoreConfiguration& configuration, const BatchTable& table, Estimates& estimates) {
  const uint32_t windows = estimates.window_counter;
  estimates = Estimates{};
  estimates.unknown_count = configuration.unknown_count;
  estimates.window_counter = windows;
  if (!any_batch(table)) return;  // every status stays STALE
  ++estimates.window_counter;
  const EquationList list = list_equations(configuration, table);
  fit.solve(list, table);
  estimate_uncertainty(list, table, fit, estimates);
  estimates.condition_number = fit.identifiability().condition_number;
  for (int k = 0; k < list.unknown_count; ++k) {
    ParameterEstimate& parameter = estimates.parameters[k];
    parameter.variance_inflation = fit.identifiability().inflation[k];
    parameter.status = judge(list, table, configuration, k, estimates);
    estimates.unresolved[k] = fit.identifiability().unresolved[k];
  }
}

}  // namespace firmware
