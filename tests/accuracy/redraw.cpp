#include "tests/accuracy/redraw.hpp"

#include <cmath>

#include "host_sim/plant/random_numbers.hpp"
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

double rms(const std::vector<double>& values, size_t count) {
  double sum = 0.0;
  for (size_t k = 0; k < count; ++k) sum += values[k] * values[k];
  return std::sqrt(sum / static_cast<double>(count));
}

}  // namespace

Redraw::Redraw(const host_sim::Scenario& scenario) : scenario_(scenario) {
  host_sim::MeasuredLevels measured = host_sim::measure(without_noise(scenario), kPlantSeed);
  calibrations_ = measured.calibrations;
  for (rig_file::ChannelCalibration& calibration : calibrations_) calibration.unit_per_code *= 2.0;  // room for noise
  configuration_ = rig_file::compile_rig(scenario.rig, scenario.sample_period_s(), calibrations_);
  configuration_.window = host_sim::scenario_window(scenario);
  core_ = std::make_unique<firmware::EstimatorCore>(configuration_);
  for (size_t l = 0; l < measured.measured.size(); ++l) {
    host_sim::Record& record = measured.measured[l];
    const host_sim::ExcitationLevel& level = scenario.levels[l];
    const auto from = static_cast<std::ptrdiff_t>(level.settle_samples);
    const auto count = static_cast<std::ptrdiff_t>(level.samples) + core_->margin_samples();
    deviation_.emplace_back();
    for (host_sim::Channel& channel : record.channels) {
      channel.values = std::vector<double>(channel.values.begin() + from, channel.values.begin() + from + count);
      deviation_.back().push_back(0.01 * noise_percent(scenario, channel.name) * rms(channel.values, level.samples));
    }
    clean_.push_back(record);
  }
  noisy_ = clean_;
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
  for (const host_sim::Record& record : noisy_) {
    host_sim::RecordSampleSource source(record, calibrations_);
    firmware::RawSample sample;
    core_->begin_level();
    uint32_t sequence = 0;
    bool first = true;
    while (source.read(sample) == hal::SampleResult::kSample) {
      if (first) sequence = next_sequence_;
      first = false;
      sample.sequence = sequence++;
      core_->push(sample);
    }
    next_sequence_ = sequence;
    core_->end_level();
  }
  return core_->solve();
}

}  // namespace accuracy
