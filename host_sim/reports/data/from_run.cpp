#include "host_sim/reports/data/from_run.hpp"

#include <algorithm>

#include "firmware/can_protocol/frame_description.hpp"
#include "firmware/can_protocol/value_tables.hpp"
#include "hal/rig_file/scaled_double.hpp"
#include "host_sim/can_log/readable.hpp"
#include "host_sim/reports/data/channel_words.hpp"
#include "host_sim/reports/views/rig_views.hpp"

namespace host_sim::reports {
namespace {

std::string plain(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::string status_word(firmware::EstimateStatus status) {
  return can_log::state_name(firmware::can::states(firmware::can::kQualityStates), static_cast<int64_t>(status));
}

std::string level_label(const Scenario& scenario, size_t index) {
  const ExcitationLevel& level = scenario.levels[index];
  const std::string number = "Level " + std::to_string(index + 1) + ": ";
  const bool rotates = level.dof >= 1 && scenario.rig.dofs[static_cast<size_t>(level.dof - 1)].rotating;
  const std::string unit = rotates ? " N·m" : " N";
  switch (level.kind) {
    case LevelKind::kSine:
      return number + "sine of " + plain(level.amplitude) + unit + " at " + plain(level.frequency_Hz) + " Hz";
    case LevelKind::kRandom:
      return number + "random, " + plain(level.rms_N) + unit + " rms, " + plain(level.low_Hz) + " to " +
             plain(level.high_Hz) + " Hz";
    case LevelKind::kFreeDecay:
      return number + "free decay";
    default:
      return number + "base motion of " + plain(level.amplitude) + (rotates ? " rad" : " m") + " at " +
             plain(level.frequency_Hz) + " Hz";
  }
}

// Forces, and of each DOF the first motion that is measured.
bool shown(const Record& record, const Channel& channel) {
  if (channel.quantity == Quantity::kForce) return true;
  for (Quantity quantity : {Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration})
    if (record.find(quantity, channel.dof) != nullptr) return quantity == channel.quantity;
  return false;
}

// The measured part of a level, without settling and run-out.
std::vector<double> measured_part(const std::vector<double>& values, const ExcitationLevel& level) {
  const size_t first = std::min(level.settle_samples, values.size());
  const size_t last = std::min(first + level.samples + 1, values.size());
  return std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(first),
                             values.begin() + static_cast<std::ptrdiff_t>(last));
}

RunRecord record_of_level(const Scenario& scenario, const RunResult& result, size_t index) {
  const ExcitationLevel& level = scenario.levels[index];
  const Record& truth = result.measured.truth[index];
  const Record& measured = result.measured.measured[index];
  RunRecord record;
  record.label = level_label(scenario, index);
  record.period_s = scenario.sample_period_s();
  for (const Channel& channel : measured.channels) {
    const Channel* clean = truth.find(channel.quantity, channel.dof);
    if (clean == nullptr || !shown(measured, channel)) continue;
    record.channels.push_back({channel_words(channel), quantity_unit(channel.quantity, channel_rotates(channel)),
                               measured_part(clean->values, level), measured_part(channel.values, level)});
  }
  if (index >= result.resimulated.size()) return record;
  for (size_t i = 0; i < scenario.rig.dofs.size(); ++i) {
    const int dof = static_cast<int>(i + 1);
    const Channel* a = truth.find(Quantity::kAcceleration, dof);
    const Channel* b = result.resimulated[index].find(Quantity::kAcceleration, dof);
    if (a == nullptr || b == nullptr) continue;
    record.accelerations.push_back({dof, quantity_unit(Quantity::kAcceleration, scenario.rig.dofs[i].rotating),
                                    result.mse_percent[i], measured_part(a->values, level),
                                    measured_part(b->values, level)});
  }
  return record;
}

// The rig with the estimates beside what the sensors delivered.
void add_views(const Scenario& scenario, const RunResult& result, RunReportData& data) {
  std::vector<double> values;
  for (const host_sim::RunParameter& parameter : result.parameters) values.push_back(parameter.value);
  const rig_file::RigModel rig = rig_file::with_values(scenario.rig, values);
  const auto without_settling = [&](std::vector<Record> records) {
    for (size_t l = 0; l < records.size(); ++l)
      for (Channel& channel : records[l].channels) channel.values = measured_part(channel.values, scenario.levels[l]);
    return records;
  };
  const std::vector<Record> records = without_settling(result.measured.measured);
  if (!records.empty()) data.views = rig_views(rig, records, without_settling(result.resimulated));
  data.views.modes = mode_rows(rig);
}

}  // namespace

void ConvergenceRecorder::begin(const Scenario& scenario, const firmware::CoreConfiguration& configuration) {
  convergence_.assign(rig_file::parameter_table(scenario.rig).size(), Convergence());
  next_.begin(scenario, configuration);
}

void ConvergenceRecorder::window(uint64_t time_ns, const firmware::Estimates& estimates,
                                 const firmware::CoreHealth& health, bool last) {
  for (size_t i = 0; i < convergence_.size(); ++i) {
    const firmware::ParameterEstimate& estimate = estimates.parameters[i];
    Convergence& run = convergence_[i];
    run.time_s.push_back(1e-9 * static_cast<double>(time_ns));
    run.value.push_back(rig_file::to_double(estimate.value));
    run.low.push_back(rig_file::to_double(estimate.ci95_low));
    run.high.push_back(rig_file::to_double(estimate.ci95_high));
  }
  next_.window(time_ns, estimates, health, last);
}

RunReportData run_report_data(const Scenario& scenario, uint64_t seed, const RunResult& result,
                              const std::vector<Convergence>& convergence) {
  RunReportData data;
  data.scenario = scenario.name;
  if (!scenario.description.empty()) data.facts.push_back(scenario.description);
  data.facts.push_back("seed " + std::to_string(seed));
  data.facts.push_back(std::to_string(result.samples) + " samples at " + plain(result.sample_rate_Hz) + " Hz");
  if (!result.mse_note.empty()) data.facts.push_back(result.mse_note);
  data.condition_number = result.condition_number;
  data.residual_mean_abs = result.residual_mean_abs;
  for (size_t i = 0; i < result.parameters.size(); ++i) {
    const host_sim::RunParameter& parameter = result.parameters[i];
    data.parameters.push_back({parameter.info.name,
                               parameter.info.unit,
                               status_word(parameter.status),
                               parameter.truth,
                               {parameter.value, parameter.ci95_low, parameter.ci95_high},
                               i < convergence.size() ? convergence[i] : Convergence()});
  }
  for (size_t level = 0; level < result.measured.truth.size(); ++level)
    data.records.push_back(record_of_level(scenario, result, level));
  add_views(scenario, result, data);
  return data;
}

}  // namespace host_sim::reports
