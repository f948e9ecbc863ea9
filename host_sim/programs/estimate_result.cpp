#include "host_sim/programs/estimate_result.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace host_sim {
namespace {

using firmware::EstimateStatus;

// JSON knows no infinity: what is beyond stays at the largest round number.
double finite(firmware::Scaled value) {
  const double result = rig_file::to_double(value);
  constexpr double kLargest = 1e300;
  return std::isfinite(result) ? std::clamp(result, -kLargest, kLargest) : std::copysign(kLargest, result);
}

const char* remedy(EstimateStatus status) {
  switch (status) {
    case EstimateStatus::kStale:
      return "no window closed: record longer, several cycles of the lowest frequency at least";
    case EstimateStatus::kIllConditioned:
      return "these data cannot separate it from the others: add a record at a second level and a second frequency "
             "(or a random band) that moves its link differently";
    case EstimateStatus::kNoExcitation:
      return "its link or DOF does not move: raise the level, or drive a DOF that moves it";
    case EstimateStatus::kSaturated:
      return "a sensor reached its full scale: lower the level or widen the sensor's range, then record again";
    default:
      return "";
  }
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
  }
  return "STALE";
}

EstimateResult result_of(const rig_file::RigModel& model, const firmware::Estimates& estimates) {
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
  result.rows = estimates.rows;
  return result;
}

std::vector<double> values_of(const EstimateResult& result) {
  std::vector<double> values;
  for (const ParameterResult& parameter : result.parameters) values.push_back(parameter.value);
  return values;
}

std::string unanswered(const EstimateResult& result) {
  std::map<EstimateStatus, std::string> names;
  for (const ParameterResult& parameter : result.parameters) {
    if (*remedy(parameter.status) == '\0') continue;
    std::string& list = names[parameter.status];
    list += (list.empty() ? "" : ", ") + parameter.info.name;
  }
  std::string text;
  for (const auto& [status, list] : names)
    text += (text.empty() ? "" : "\n  ") + list + " is " + status_word(status) + ": " + remedy(status);
  return text;
}

}  // namespace host_sim
