#include "tests/accuracy/redraw.hpp"

#include <algorithm>
#include <cmath>

#include "hal/rig_file/channel_entry.hpp"
#include "hal/rig_file/signal_plan.hpp"
#include "host_sim/plant/instruments/random_numbers.hpp"
#include "host_sim/records/digitise.hpp"
#include "host_sim/virtual_rig/run_scenario.hpp"

namespace accuracy {
namespace {

constexpr uint64_t kPlantSeed = 1;  // of the random force; the noise has seeds of its own

host_sim::Scenario without_noise(host_sim::Scenario scenario) {
  scenario.sensors.every.noise_percent = 0.0;
  for (auto& [name, channel] : scenario.sensors.channel) channel.noise_percent = 0.0;
  return scenario;
}

double noise_percent(const host_sim::Scenario& scenario, const std::string& channel) {
  const auto found = scenario.sensors.channel.find(channel);
  return (found == scenario.sensors.channel.end() ? scenario.sensors.every : found->second).noise_percent;
}

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

// The filters' margin follows from which channels there are, not from their ranges.
size_t filter_margin(const host_sim::Scenario& scenario) {
  std::vector<rig_file::ChannelCalibration> calibrations;
  for (const host_sim::Channel& channel : host_sim::measured_channels(scenario)) {
    calibrations.emplace_back();
    calibrations.back().quantity = static_cast<firmware::Quantity>(channel.quantity);
    calibrations.back().dof = channel.dof;
    calibrations.back().delay_s = rig_file::stated_delay_s(scenario.rig, channel.name);
  }
  const firmware::CoreConfiguration configuration =
      rig_file::compile_rig(scenario.rig, scenario.sample_period_s(), calibrations);
  return static_cast<size_t>(std::make_unique<firmware::EstimatorCore>(configuration)->margin_samples());
}

std::vector<firmware::RawSample> to_codes(const host_sim::Record& record,
                                          const std::vector<rig_file::ChannelCalibration>& calibrations) {
  host_sim::RecordSampleSource source(record, calibrations);
  std::vector<firmware::RawSample> samples(record.samples());
  for (firmware::RawSample& sample : samples) source.read(sample);
  return samples;
}

}  // namespace

Redraw::Redraw(const host_sim::Scenario& scenario) : scenario_(scenario) {
  const size_t margin = filter_margin(scenario);
  host_sim::Scenario clean = without_noise(scenario);
  for (host_sim::ExcitationLevel& level : clean.levels)
    level.run_out_samples = std::max(host_sim::kRunOutSamples, margin - std::min(margin, level.settle_samples));
  host_sim::MeasuredLevels measured = host_sim::measure(clean, kPlantSeed);
  calibrations_ = measured.calibrations;
  for (rig_file::ChannelCalibration& calibration : calibrations_) calibration.unit_per_code *= 2.0;  // room for noise
  configuration_ = rig_file::compile_rig(scenario.rig, scenario.sample_period_s(), calibrations_);
  configuration_.window = host_sim::scenario_window(scenario);
  for (size_t l = 0; l < measured.measured.size(); ++l) {
    host_sim::Record& record = measured.measured[l];
    const host_sim::ExcitationLevel& level = scenario.levels[l];
    // What the filters need comes from the settling where there is enough of it, as in a run.
    const auto from = static_cast<std::ptrdiff_t>(level.settle_samples - std::min(margin, level.settle_samples));
    const auto count = static_cast<std::ptrdiff_t>(level.samples + margin);
    deviation_.emplace_back();
    for (host_sim::Channel& channel : record.channels) {
      channel.values = std::vector<double>(channel.values.begin() + from, channel.values.begin() + from + count);
      deviation_.back().push_back(0.01 * noise_percent(scenario, channel.name) * rms(channel.values));
    }
    clean_.push_back(record);
  }
  noisy_ = clean_;
  if (!rig_file::describe_plan(configuration_).empty()) fit_derived_signals();
  core_ = std::make_unique<firmware::EstimatorCore>(configuration_);
}

// Signals that must be derived get the resolution that one noisy draw allows, and as much again.
void Redraw::fit_derived_signals() {
  draw(0, true);
  std::vector<std::vector<firmware::RawSample>> samples;
  for (const host_sim::Record& record : noisy_) samples.push_back(to_codes(record, calibrations_));
  rig_file::plan_signals(configuration_, rig_file::measure_ranges(configuration_, samples));
}

void Redraw::draw(uint64_t seed, bool noisy) {
  for (size_t l = 0; l < clean_.size(); ++l)
    for (size_t c = 0; c < clean_[l].channels.size(); ++c) {
      const std::vector<double>& clean = clean_[l].channels[c].values;
      std::vector<double>& values = noisy_[l].channels[c].values;
      host_sim::RandomNumbers random(seed, 100 * l + c);
      const double deviation = noisy ? deviation_[l][c] : 0.0;
      for (size_t k = 0; k < clean.size(); ++k)
        values[k] = deviation == 0.0 ? clean[k] : clean[k] + deviation * random.normal();
    }
}

const firmware::Estimates& Redraw::run(uint64_t seed, bool noisy) {
  draw(seed, noisy);
  core_->reset();
  codes_.clear();
  for (const host_sim::Record& record : noisy_) {
    codes_.push_back(to_codes(record, calibrations_));
    core_->begin_level();
    for (firmware::RawSample& sample : codes_.back()) {
      sample.sequence = next_sequence_++;
      core_->push(sample);
    }
    core_->end_level();
  }
  return core_->solve();
}

}  // namespace accuracy
