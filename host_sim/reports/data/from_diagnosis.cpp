#include "host_sim/reports/data/from_diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "hal/rig_file/coefficient_walk.hpp"
#include "host_sim/diagnosis/numbers/parameter_status.hpp"
#include "host_sim/reports/data/candidates.hpp"
#include "host_sim/reports/data/record_words.hpp"
#include "host_sim/reports/figures/numbers.hpp"
#include "host_sim/reports/views/comparison.hpp"
#include "host_sim/reports/views/free_simulation.hpp"
#include "host_sim/reports/views/rig_views.hpp"

namespace host_sim::reports {
namespace {

constexpr double kNone = NAN;

Interval interval_of(const diagnosis::Parameter& parameter) {
  if (!(parameter.std > 0.0)) return {parameter.value, kNone, kNone};
  const double half = diagnosis::kHalfOf95 * parameter.std;
  return {parameter.value, parameter.value - half, parameter.value + half};
}

constexpr double kNoMagnitude = 10;  // standard deviations over the number: not even how large it is is known

// A number to show: none where the records do not tell its order of magnitude.
Interval shown(const diagnosis::Parameter& p) {
  if (p.undetermined && p.std > kNoMagnitude * std::abs(p.value)) return {kNone, kNone, kNone};
  return interval_of(p);
}

std::string parameter_text(const diagnosis::Parameter& parameter) {
  const Interval interval = interval_of(parameter);
  std::string text = parameter.name + " = " + number_text(parameter.value, 4) + " " + unit_text(parameter.unit);
  if (std::isfinite(interval.low))
    text += " (95 %: " + number_text(interval.low, 4) + " to " + number_text(interval.high, 4) + ")";
  return text;
}

Cause cause_of(const diagnosis::Cause& from) {
  Cause cause{from.effect, from.where, from.taken_out ? std::nan("") : from.explains_percent, {}};
  for (const diagnosis::Parameter& parameter : from.parameters) cause.parameters.push_back(parameter_text(parameter));
  for (const diagnosis::NamedPlace& place : from.rivals) cause.rivals.push_back({place.effect, place.where});
  return cause;
}

const diagnosis::Parameter* find(const std::vector<diagnosis::Parameter>& parameters, const std::string& name) {
  for (const diagnosis::Parameter& parameter : parameters)
    if (parameter.name == name) return &parameter;
  return nullptr;
}

// Given values have no status.
std::string status_of(const diagnosis::Parameter& p, bool model_fits) {
  return p.std > 0.0 ? diagnosis::status_word(p, model_fits) : "";
}

// Those of the rig as given in their order, then what the extended rig adds.
std::vector<ParameterChange> changes(const diagnosis::Diagnosis& found) {
  std::vector<ParameterChange> out;
  const Interval nothing{kNone, kNone, kNone};
  for (const diagnosis::Parameter& before : found.baseline.parameters) {
    const diagnosis::Parameter* after = found.causes.empty() ? nullptr : find(found.extended.parameters, before.name);
    out.push_back({before.name, before.unit, shown(before), after ? shown(*after) : nothing,
                   after ? status_of(*after, found.extended_fits()) : status_of(before, found.baseline_fits()),
                   impossible(before) && !before.undetermined});
  }
  for (const diagnosis::Parameter& after : found.extended.parameters)
    if (!found.causes.empty() && find(found.baseline.parameters, after.name) == nullptr)
      out.push_back({after.name, after.unit, nothing, shown(after), status_of(after, found.extended_fits())});
  return out;
}

double at(const std::vector<double>& values, size_t index) { return index < values.size() ? values[index] : kNone; }

std::vector<DofGain> gains(const diagnosis::Diagnosis& found) {
  std::vector<DofGain> out;
  const size_t dofs = found.baseline.holdout_nrmse_percent.size();
  const bool extended = !found.causes.empty();
  for (size_t i = 0; i < dofs; ++i)
    out.push_back({static_cast<int>(i + 1), at(found.baseline.holdout_nrmse_percent, i),
                   extended ? at(found.extended.holdout_nrmse_percent, i) : kNone,
                   at(found.baseline.holdout_mse_percent, i),
                   extended ? at(found.extended.holdout_mse_percent, i) : kNone});
  return out;
}

std::string text(double value, const char* format) {
  char out[64];
  std::snprintf(out, sizeof out, format, value);
  return out;
}

}  // namespace

rig_file::RigModel with_parameters(const rig_file::RigModel& rig, const std::vector<diagnosis::Parameter>& parameters) {
  rig_file::RigModel out = rig;
  rig_file::walk_coefficients(out, [&](const rig_file::CoefficientSite& site, rig_file::Coefficient& coefficient) {
    if (!coefficient.estimate) return;
    if (const diagnosis::Parameter* parameter = find(parameters, site.name)) coefficient.value = parameter->value;
    coefficient.estimate = false;
  });
  return out;
}

DiagnosisReportData findings_of(const rig_file::RigModel& rig, const std::vector<Record>& training,
                                const std::vector<Record>& holdout, const diagnosis::Diagnosis& found) {
  DiagnosisReportData data;
  data.rig_name = rig.name.empty() ? "the rig" : rig.name;
  for (const Record& record : training) data.files.push_back(std::filesystem::path(record.file).filename().string());
  for (const Record& record : holdout)
    data.facts.push_back("held out: " + std::filesystem::path(record.file).filename().string());
  data.facts.push_back(lengths_text(training) + text(1.0 / training.front().sample_period_s, " at %g Hz"));
  data.leaves_noise_alone = found.leaves_noise_alone();
  data.more_remains = found.more_remains;
  data.noise_hides = found.noise_hides();
  data.cannot_describe = found.cannot_describe;
  data.channels_left_out = found.channels_left_out;
  data.told_from_s = found.told_from_s;
  data.determines_nothing = found.determines_nothing;
  data.along_motion = found.along_motion;
  data.odd_record = odd_record_text(found);
  const bool extended = !found.causes.empty();
  data.facts.push_back(text(found.baseline_misfit, "misfit (1 is noise alone): %.3g") +
                       (extended ? text(found.extended_misfit, " as given, %.3g extended") : ""));
  data.verdict = diagnosis::verdict_word(found.verdict);
  for (const diagnosis::Cause& cause : found.causes) data.causes.push_back(cause_of(cause));
  for (const diagnosis::NamedPlace& place : found.ambiguous_with)
    data.ambiguous_with.push_back({place.effect, place.where});
  for (const diagnosis::PossibleCause& c : found.possible) {
    data.possible.push_back({c.place.effect, c.place.where, c.explains_percent, "", ""});
    if (c.bends.empty()) continue;
    data.possible.back().bends = c.bends[0].name;
    data.possible.back().to = text(c.bends[0].value, "%.3g ") + c.bends[0].unit;
  }
  data.parameters = changes(found);
  data.gains = gains(found);
  data.candidates = candidates(found);
  data.score_name = "significance";
  for (const diagnosis::DetectionLimit& limit : found.minimum_detectable) {
    data.minimum_detectable.push_back({limit.effect, limit.where, limit.unit, limit.strength});
    const double percent = limit.percent_of_damping_force;
    if (percent > 0 && std::isfinite(percent)) data.minimum_detectable.back().percent_of_damping_force = percent;
  }
  data.advice = found.advice;
  return data;
}

void add_pictures(const rig_file::RigModel& rig, const std::vector<Record>& training,
                  const std::vector<Record>& holdout, const diagnosis::Diagnosis& found, DiagnosisReportData& data) {
  const std::vector<Record>& among = holdout.empty() ? training : holdout;
  const bool is_extended = !found.causes.empty() && !found.extended_rig.dofs.empty();
  const rig_file::RigModel given = with_parameters(rig, found.baseline.parameters);
  const rig_file::RigModel best = is_extended ? with_parameters(found.extended_rig, found.extended.parameters) : given;
  std::vector<std::string> unable;
  const std::vector<Record> as_given = simulate_all(given, among, unable);
  const std::vector<Record> simulated =
      !is_extended && holdout.empty() ? as_given : simulate_all(best, training, unable);
  // An effect may be at work in one record alone: where the rig as given fits, there is nothing to see.
  const size_t worst = worst_record(among, as_given);
  const Record& shown = among[worst];
  const Side given_side{given, as_given.empty() ? nullptr : &as_given[worst]};
  const Record* by_best = holdout.empty() && !simulated.empty() ? &simulated[worst] : nullptr;
  const Comparison comparison = is_extended ? compare(shown, given_side, {best, by_best}) : compare(shown, given_side);
  data.views = rig_views(best, training, simulated);
  data.views.of_extended_rig = is_extended;
  data.views.modes = mode_rows(best);
  data.dofs = comparison.dofs;
  data.free = comparison.free;
  data.links = comparison.links;
  data.facts.push_back("pictures: " + std::filesystem::path(shown.file).filename().string() +
                       (holdout.empty() ? ", which the fit has seen" : ", which the fit has not seen") +
                       (among.size() > 1 && !as_given.empty() ? " and the rig as given misses most" : ""));
  data.facts.insert(data.facts.end(), comparison.notes.begin(), comparison.notes.end());
}

}  // namespace host_sim::reports
