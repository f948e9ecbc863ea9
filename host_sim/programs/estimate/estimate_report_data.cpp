#include "host_sim/programs/estimate/estimate_report_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "host_sim/reports/views/comparison.hpp"
#include "host_sim/reports/views/free_simulation.hpp"
#include "host_sim/reports/views/rig_views.hpp"

namespace host_sim {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

reports::Interval interval_of(const ParameterResult& p) {
  if (!p.has_interval()) return {p.value, kNone, kNone};
  return {p.value, p.ci95_low, p.ci95_high};
}

void add_facts(const std::vector<Record>& records, const EstimateResult& result, reports::EstimateReportData& data) {
  for (const Record& record : records) data.files.push_back(std::filesystem::path(record.file).filename().string());
  data.facts.push_back(std::to_string(result.samples) + fmt::format(" samples at {:g} Hz", result.sample_rate_Hz));
  data.facts.push_back(fmt::format("condition number {:.3g}", result.condition_number));
  for (size_t i = 0; i < result.mse_percent.size(); ++i)
    if (result.mse_percent[i])
      data.facts.push_back("MSE of DOF " + std::to_string(i + 1) +
                           fmt::format(" (Eq. 13) {:.3g} %", *result.mse_percent[i]));
}

}  // namespace

std::vector<UncertainMode> estimated_modes(const rig_file::RigModel& model, const EstimateResult& result) {
  // Intervals of coefficients are Student's, with the degrees of freedom of each: those of the modes are widened alike.
  std::vector<std::vector<double>> covariance = result.covariance;
  const auto widening = [&](size_t i) {
    const ParameterResult& p = result.parameters[i];
    const double normal = 2.0 * 1.959963984540054 * p.std;
    return normal > 0.0 ? std::max(1.0, (p.ci95_high - p.ci95_low) / normal) : 1.0;
  };
  for (size_t i = 0; i < covariance.size(); ++i)
    for (size_t j = 0; j < covariance[i].size(); ++j) covariance[i][j] *= widening(i) * widening(j);
  return modes_with_intervals(model, values_of(result), covariance);
}

reports::EstimateReportData estimate_report_data(const rig_file::RigModel& model, const std::vector<Record>& records,
                                                 const EstimateResult& result, const std::vector<Record>& simulated) {
  reports::EstimateReportData data;
  data.rig_name = model.name.empty() ? "the rig" : model.name;
  add_facts(records, result, data);
  for (const ParameterResult& p : result.parameters)
    data.parameters.push_back({p.info.name, p.info.unit, {kNone, kNone, kNone}, interval_of(p), status_word(p.status)});
  data.advice = next_steps(result);
  data.notes = result.notes;
  const rig_file::RigModel rig = rig_file::with_values(model, values_of(result));
  const size_t worst = reports::worst_record(records, simulated);
  if (records.size() > 1)
    data.facts.push_back("pictures: " + std::filesystem::path(records[worst].file).filename().string() +
                         (simulated.empty() ? ", the first record" : ", the record that the simulation misses most"));
  reports::Comparison comparison =
      reports::compare(records[worst], {rig, simulated.empty() ? nullptr : &simulated[worst]});
  data.dofs = std::move(comparison.dofs);
  data.free = comparison.free;
  data.notes.insert(data.notes.end(), comparison.notes.begin(), comparison.notes.end());
  data.views = reports::rig_views(rig, records, simulated);
  data.views.modes = reports::mode_rows(estimated_modes(model, result));
  data.warrant = warrant_view(result.warrant);
  return data;
}

reports::WarrantView warrant_view(const WarrantResult& warrant) {
  const auto finding = [](const FindingResult& from) {
    return reports::WarrantFinding{from.effect, from.where, from.unit, from.size, from.std};
  };
  return {warrant.tested, finding(warrant.named), finding(warrant.rival), warrant.rival_percent,
          why_not_the_cause(warrant)};
}

}  // namespace host_sim
