#include "host_sim/programs/results/result_json.hpp"

namespace host_sim {
namespace {

using nlohmann::ordered_json;

ordered_json to_json(const ParameterResult& parameter) {
  ordered_json json = {{"name", parameter.info.name},
                       {"value", parameter.value},
                       {"unit", parameter.info.unit},
                       {"std", parameter.std},
                       {"ci95", {parameter.ci95_low, parameter.ci95_high}},
                       {"status", status_word(parameter.status)}};
  if (parameter.truth) json["truth"] = *parameter.truth;
  if (parameter.paper) json["paper"] = *parameter.paper;
  return json;
}

ordered_json to_json(const FindingResult& finding) {
  return {{"effect", finding.effect},
          {"where", finding.where},
          {"size", finding.size},
          {"std", finding.std},
          {"unit", finding.unit}};
}

ordered_json to_json(const WarrantResult& warrant) {
  ordered_json json = {{"tested", warrant.tested}};
  for (const FindingResult& finding : warrant.corrected) json["corrected"].push_back(to_json(finding));
  if (warrant.named.effect.empty()) return json;
  const std::string why_not = why_not_the_cause(warrant);
  ordered_json& named = json[why_not.empty() ? "suspect" : "nearest"];
  named = to_json(warrant.named);
  if (warrant.explains_percent != 0.0) named["explains_percent"] = warrant.explains_percent;
  if (!why_not.empty()) named["not_the_cause"] = why_not;
  if (warrant.rival.effect.empty()) return json;
  json["rival"] = to_json(warrant.rival);
  json["rival"]["likelihood_percent"] = warrant.rival_percent;
  return json;
}

}  // namespace

ordered_json to_json(const EstimateResult& result) {
  ordered_json json = {{"schema", "estimate/1"}, {"parameters", ordered_json::array()}};
  for (const ParameterResult& parameter : result.parameters) json["parameters"].push_back(to_json(parameter));
  json["residual_mean_abs"] = result.residual_mean_abs;
  if (result.paper_residual) json["paper_residual_mean_abs"] = *result.paper_residual;
  json["condition_number"] = result.condition_number;
  json["mse_percent"] = ordered_json::array();
  for (const auto& mse : result.mse_percent) json["mse_percent"].push_back(mse ? ordered_json(*mse) : ordered_json());
  if (!result.paper_mse_percent.empty()) json["paper_mse_percent"] = result.paper_mse_percent;
  json["mse_of"] = result.mse_of;
  if (!result.mse_note.empty()) json["mse_note"] = result.mse_note;
  json["samples"] = result.samples;
  json["sample_rate_Hz"] = result.sample_rate_Hz;
  json["levels"] = result.levels;
  json["equations"] = result.rows;
  json["missed_samples"] = result.health.missed_samples;
  json["saturated_samples"] = result.health.saturated_samples;
  json["skew_us"] = ordered_json::array();
  for (const SkewResult& skew : result.skews)
    json["skew_us"].push_back(
        {{"channel", skew.channel}, {"late", skew.late_us}, {"std", skew.std_us}, {"significant", skew.significant}});
  json["warrant"] = to_json(result.warrant);
  json["unresolved"] = result.unresolved;
  json["advice"] = next_steps(result);
  json["notes"] = result.notes;
  return json;
}

std::string to_text(const ordered_json& json) {
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace host_sim
