#include "host_sim/programs/results/estimate_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "host_sim/programs/results/advice.hpp"
#include "host_sim/programs/results/level_ratio.hpp"
#include "host_sim/programs/results/reasons.hpp"
#include "host_sim/programs/shared/any_force.hpp"
#include "host_sim/vocabulary/held_in_place.hpp"

namespace host_sim {
namespace {

using firmware::EstimateStatus;

// JSON knows no infinity: what is beyond stays at the largest round number.
double finite(firmware::Scaled value) {
  const double result = rig_file::to_double(value);
  constexpr double kLargest = 1e300;
  return std::isfinite(result) ? std::clamp(result, -kLargest, kLargest) : std::copysign(kLargest, result);
}

}  // namespace

const char* status_word(EstimateStatus status) {
  switch (status) {
    case EstimateStatus::kValid:
      return "VALID";
    case EstimateStatus::kStale:
      return "STALE";
    case EstimateStatus::kBiasSuspect:
      return "BIAS_SUSPECT";
    case EstimateStatus::kSkewed:
      return "SKEWED";
    case EstimateStatus::kIllConditioned:
      return "ILL_CONDITIONED";
    case EstimateStatus::kNoExcitation:
      return "NO_EXCITATION";
    case EstimateStatus::kSaturated:
      return "SATURATED";
    case EstimateStatus::kModelSuspect:
      return "MODEL_SUSPECT";
    case EstimateStatus::kUntested:
      return "UNTESTED";
  }
  return "STALE";
}

EstimateResult result_of(const rig_file::RigModel& model, const firmware::Estimates& estimates,
                         const std::vector<Record>& records) {
  EstimateResult result;
  const std::vector<rig_file::ParameterInfo> table = rig_file::parameter_table(model);
  for (size_t i = 0; i < table.size(); ++i) {
    const firmware::ParameterEstimate& estimate = estimates.parameters[i];
    ParameterResult parameter;
    parameter.info = table[i];
    parameter.value = finite(estimate.value);
    parameter.std = finite(estimate.std);
    parameter.ci95_low = std::min(finite(estimate.ci95_low), parameter.value);
    parameter.ci95_high = std::max(finite(estimate.ci95_high), parameter.value);
    parameter.status = i < estimates.unknown_count ? estimate.status : EstimateStatus::kStale;
    result.parameters.push_back(parameter);
  }
  result.residual_mean_abs = finite(estimates.residual_mean_abs);
  result.condition_number = finite(estimates.condition_number);
  result.inseparable = estimates.inseparable;
  result.rows = estimates.rows;
  result.has_rates = has_rates(records), result.swings = fewest_swings(records);
  result.held = vocabulary::held_in_place(model);
  result.force_known = records.empty() || any_force(records) || states_a_coefficient(model);
  result.skews = skews_of(model, estimates, records);
  result.warrant = warrant_of(model, estimates.warrant);
  result.advice = advice_text(model, estimates, result.skews, level_ratio(records));
  result.unresolved = unresolved_text(model, estimates);
  for (const SkewResult& skew : result.skews)
    if (skew.significant) result.notes.push_back(skew_note(skew));
  return result;
}

std::vector<double> values_of(const EstimateResult& result) {
  std::vector<double> values;
  for (const ParameterResult& parameter : result.parameters) values.push_back(parameter.value);
  return values;
}

std::vector<std::string> next_steps(const EstimateResult& result) {
  if (suspects(result.warrant)) return {after_suspicion(result.warrant)};
  return result.advice.empty() ? std::vector<std::string>{} : std::vector<std::string>{result.advice};
}

std::string unanswered(const EstimateResult& result) {
  std::map<EstimateStatus, std::string> names;
  for (const ParameterResult& parameter : result.parameters) {
    if (reason(parameter.status, result).empty()) continue;
    std::string& list = names[parameter.status];
    list += (list.empty() ? "" : ", ") + parameter.info.name;
  }
  std::string text;
  for (const auto& [status, list] : names)
    text += (text.empty() ? "" : "\n  ") + list + ": " + status_word(status) + ", " + reason(status, result);
  if (text.empty()) return text;
  const bool entangled = result.hum_in.empty() && names.count(EstimateStatus::kIllConditioned) > 0 &&
                         !result.unresolved.empty() && !hidden_by_noise(EstimateStatus::kIllConditioned, result);
  if (entangled) text += "\n  hardly seen is the change " + result.unresolved;
  const bool noise = hidden_by_noise(EstimateStatus::kIllConditioned, result);
  if (!result.force_known) return text;  // no other level or frequency brings one
  if (!result.hum_in.empty()) return text + "\n  measure instead: the same without the hum";
  if (!result.advice.empty() && !(noise && names.size() == 1 && names.count(EstimateStatus::kIllConditioned) == 1))
    text += "\n  measure instead: " + result.advice;
  return text;
}

std::vector<std::vector<double>> covariance_of(const EstimateResult& result, const firmware::EstimatorCore& core) {
  const size_t n = result.parameters.size();
  std::vector<std::vector<double>> out(n, std::vector<double>(n, 0.0));
  const auto entry = [&](size_t i, size_t j) {
    return rig_file::to_double(core.normal_equations().covariance(static_cast<int>(i), static_cast<int>(j)));
  };
  for (size_t i = 0; i < n; ++i)
    for (size_t j = 0; j < n; ++j) {
      const double size = std::sqrt(entry(i, i) * entry(j, j));
      const double correlation = i == j ? 1.0 : size > 0.0 ? entry(i, j) / size : 0.0;
      out[i][j] = correlation * result.parameters[i].std * result.parameters[j].std;
    }
  return out;
}

}  // namespace host_sim
