// Contract section 5, "diagnosis/1".
#include <nlohmann/json.hpp>

#include "diagnosis.hpp"
#include "numbers/parameter_status.hpp"

namespace diagnosis {
namespace {

using nlohmann::json;

// Shapes and given values have no scatter of their own: an interval of no width.
json to_json(const Parameter& p) {
  return {{"name", p.name},
          {"value", p.value},
          {"unit", p.unit},
          {"std", p.std},
          {"ci95", {p.value - kHalfOf95 * p.std, p.value + kHalfOf95 * p.std}}};
}

json to_json(const std::vector<Parameter>& list) {
  json j = json::array();
  for (const Parameter& p : list) j.push_back(to_json(p));
  return j;
}

json to_json(const std::vector<NamedPlace>& places) {
  json j = json::array();
  for (const NamedPlace& p : places) j.push_back({p.effect, p.where});
  return j;
}

json to_json(const Cause& c) {
  return {{"effect", c.effect},
          {"where", c.where},
          {"parameters", to_json(c.parameters)},
          {"explains_percent", c.explains_percent},
          {"significance", c.significance},
          {"rivals", to_json(c.rivals)}};
}

json odd_record(const Diagnosis& d) {
  if (!d.odd_record) return nullptr;
  return {{"record", d.odd_record->record + 1},
          {"file", d.odd_record->file},
          {"missed_percent", d.odd_record->missed_percent},
          {"others_percent", d.odd_record->others_percent}};
}

json to_json(const ModelScore& s, bool fits) {
  json parameters = to_json(s.parameters);
  for (size_t i = 0; i < s.parameters.size(); ++i) parameters[i]["status"] = status_word(s.parameters[i], fits);
  return {{"parameters", std::move(parameters)},
          {"holdout_nrmse_percent", s.holdout_nrmse_percent},
          {"holdout_velocity_nrmse_percent", s.holdout_velocity_nrmse_percent},
          {"holdout_mse_percent", s.holdout_mse_percent}};
}

}  // namespace

json to_json(const Diagnosis& d) {
  json j{{"schema", "diagnosis/1"},
         {"verdict", verdict_word(d.verdict)},
         {"baseline", to_json(d.baseline, d.baseline_fits())},
         {"extended", to_json(d.extended, d.extended_fits())},
         {"gain", d.gain},
         {"remainder_percent", d.remainder_percent},
         {"advice", d.advice},
         {"cannot_describe", d.cannot_describe},
         {"channels_left_out", d.channels_left_out},
         {"told_from_s", d.told_from_s},
         {"determines_nothing", d.determines_nothing},
         {"along_motion", d.along_motion},
         {"odd_record", odd_record(d)},
         {"force_between_samples", d.force_between_samples},
         {"unknown_trace", d.unknown_trace},
         {"baseline_misfit", d.baseline_misfit},
         {"extended_misfit", d.extended_misfit}};
  j["ambiguous_with"] = to_json(d.ambiguous_with);
  j["causes"] = j["minimum_detectable"] = j["rejected"] = json::array();
  for (const Cause& c : d.causes) j["causes"].push_back(to_json(c));
  j["possible"] = json::array();
  for (const PossibleCause& c : d.possible)
    j["possible"].push_back({{"effect", c.place.effect},
                             {"where", c.place.where},
                             {"explains_percent", c.explains_percent},
                             {"bends", to_json(c.bends)}});
  for (const Cause& c : d.rejected) j["rejected"].push_back(to_json(c));
  for (const DetectionLimit& l : d.minimum_detectable)
    j["minimum_detectable"].push_back({{"effect", l.effect},
                                       {"where", l.where},
                                       {"strength", l.strength},
                                       {"unit", l.unit},
                                       {"percent_of_damping_force", l.percent_of_damping_force}});
  return j;
}

}  // namespace diagnosis
