#include "host_sim/programs/run_report.hpp"

#include <cmath>
#include <limits>

#include "hal/configuration/channel_name.hpp"
#include "host_sim/reports/report.hpp"

namespace host_sim {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::string level_label(const ExcitationLevel& level) {
  switch (level.kind) {
    case LevelKind::kSine:
      return "sine " + number(level.amplitude) + " N, " + number(level.frequency_Hz) + " Hz";
    case LevelKind::kRandom:
      return "random, rms " + number(level.rms_N) + " N, " + number(level.low_Hz) + " to " + number(level.high_Hz) +
             " Hz";
    case LevelKind::kBaseSine:
      return "base " + number(level.amplitude) + " m, " + number(level.frequency_Hz) + " Hz";
    case LevelKind::kFreeDecay:
      return "free decay";
  }
  return "";
}

const char* unit_of(Quantity quantity, bool rotating) {
  switch (quantity) {
    case Quantity::kForce:
      return rotating ? "N m" : "N";
    case Quantity::kDisplacement:
      return rotating ? "rad" : "m";
    case Quantity::kVelocity:
      return rotating ? "rad/s" : "m/s";
    case Quantity::kAcceleration:
      return rotating ? "rad/s^2" : "m/s^2";
  }
  return "";
}

bool rotates(const Scenario& scenario, int dof) {
  const size_t index = dof > 0 ? static_cast<size_t>(dof - 1) : 0;
  return scenario.rig.dofs[index].rotating;
}

// The measured part of a channel: without settling and run-out.
std::vector<double> measured_part(const std::vector<double>& values, const ExcitationLevel& level) {
  const auto from = values.begin() + static_cast<std::ptrdiff_t>(level.settle_samples);
  return {from, from + static_cast<std::ptrdiff_t>(level.samples)};
}

std::vector<reports::RunChannel> channels_of(const Scenario& scenario, const RunResult& run, size_t index) {
  std::vector<reports::RunChannel> channels;
  const Record& truth = run.measured.truth[index];
  for (const Channel& channel : run.measured.measured[index].channels) {
    const Channel* clean = truth.find(channel.quantity, channel.dof);
    if (clean == nullptr) continue;
    channels.push_back({channel.name, unit_of(channel.quantity, rotates(scenario, channel.dof)),
                        measured_part(clean->values, scenario.levels[index]),
                        measured_part(channel.values, scenario.levels[index])});
  }
  return channels;
}

std::vector<reports::RunAcceleration> accelerations_of(const Scenario& scenario, const RunResult& run, size_t index) {
  std::vector<reports::RunAcceleration> accelerations;
  if (index >= run.resimulated.size()) return accelerations;
  for (size_t i = 0; i < scenario.rig.dofs.size(); ++i) {
    const int dof = static_cast<int>(i + 1);
    reports::RunAcceleration acceleration;
    acceleration.dof = dof;
    acceleration.unit = unit_of(Quantity::kAcceleration, rotates(scenario, dof));
    acceleration.mse_percent = run.mse_percent[i];
    acceleration.measured =
        measured_part(run.measured.truth[index].find(Quantity::kAcceleration, dof)->values, scenario.levels[index]);
    acceleration.simulated =
        measured_part(run.resimulated[index].find(Quantity::kAcceleration, dof)->values, scenario.levels[index]);
    accelerations.push_back(std::move(acceleration));
  }
  return accelerations;
}

}  // namespace

void ConvergenceRecorder::add(uint64_t time_ns, const firmware::Estimates& estimates) {
  time_s_.push_back(static_cast<double>(time_ns) * 1e-9);
  points_.resize(estimates.unknown_count);
  for (size_t i = 0; i < points_.size(); ++i) {
    const firmware::ParameterEstimate& p = estimates.parameters[i];
    points_[i].push_back(
        {rig_file::to_double(p.value), rig_file::to_double(p.ci95_low), rig_file::to_double(p.ci95_high)});
  }
}

void write_run_report_of(const std::string& folder, const Scenario& scenario, uint64_t seed, const RunResult& run,
                         const EstimateResult& result, const ConvergenceRecorder& convergence) {
  reports::RunReportData data;
  data.scenario = scenario.name;
  data.facts = {scenario.description, "seed " + std::to_string(seed), number(scenario.sample_rate_Hz) + " Hz",
                std::to_string(result.samples) + " samples"};
  data.condition_number = result.condition_number;
  data.residual_mean_abs = result.residual_mean_abs;
  for (size_t i = 0; i < result.parameters.size(); ++i) {
    const ParameterResult& parameter = result.parameters[i];
    reports::RunParameter shown;
    shown.name = parameter.info.name;
    shown.unit = parameter.info.unit;
    shown.status = status_word(parameter.status);
    shown.truth = parameter.truth.value_or(kNone);
    shown.estimate = {parameter.value, parameter.ci95_low, parameter.ci95_high};
    shown.convergence.time_s = convergence.time_s();
    for (const ConvergenceRecorder::Point& point : convergence.points(i)) {
      shown.convergence.value.push_back(point.value);
      shown.convergence.low.push_back(point.low);
      shown.convergence.high.push_back(point.high);
    }
    data.parameters.push_back(std::move(shown));
  }
  for (size_t i = 0; i < scenario.levels.size(); ++i)
    data.records.push_back({level_label(scenario.levels[i]), 0.0, scenario.sample_period_s(),
                            channels_of(scenario, run, i), accelerations_of(scenario, run, i)});
  reports::write_run_report(folder, data);
}

}  // namespace host_sim
