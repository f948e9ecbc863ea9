#include "host_sim/programs/estimate/records_configuration.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "hal/rig_file/first_batches.hpp"
#include "hal/rig_file/recorded/channel_noise.hpp"
#include "hal/rig_file/signal_plan.hpp"
#include "hal/rig_file/whole_cycles.hpp"
#include "host_sim/programs/shared/failures.hpp"
#include "host_sim/records/digitise.hpp"
#include "host_sim/records/record_checks.hpp"

namespace host_sim {
namespace {

firmware::WindowConfiguration window_of(const std::vector<Record>& records, std::optional<double> excitation_Hz) {
  const Record& record = records.front();
  firmware::WindowConfiguration window;
  window.mode = any_has_drive(records) ? firmware::WindowMode::kInterval : firmware::WindowMode::kFreeDecay;
  if (!excitation_Hz) {
    size_t shortest = record.samples();
    for (const Record& other : records) shortest = std::min(shortest, other.samples());
    window.batch_samples = rig_file::first_batch_samples(shortest);
    return window;
  }
  const double cycle_samples = 1.0 / (*excitation_Hz * record.sample_period_s);
  if (!rig_file::can_be_whole(cycle_samples) || cycle_samples > static_cast<double>(record.samples()))
    throw UsageError("--frequency is " + std::to_string(*excitation_Hz) +
                     " Hz, expected a cycle of 4 samples to the length of " + record.file);
  rig_file::set_whole_cycles(cycle_samples, window);
  return window;
}

// Noise that has a colour is in the neighbours of a sample, though nothing is filtered.
bool coloured_displacement(const std::vector<Record>& records,
                           const std::vector<rig_file::ChannelCalibration>& calibrations) {
  for (const rig_file::ChannelCalibration& calibration : calibrations) {
    if (calibration.quantity != firmware::Quantity::kDisplacement) continue;
    rig_file::ChannelCodes codes;
    for (const Record& record : records) {
      const Channel* const channel = record.find(Quantity::kDisplacement, calibration.dof);
      if (channel == nullptr) break;
      codes.emplace_back();
      for (const double value : channel->values) codes.back().push_back(to_code(value, calibration));
    }
    if (rig_file::hardly_noisy(codes)) continue;
    if (!rig_file::read_noise(codes, static_cast<int>(calibration.quantity), 1.0 / records.front().sample_period_s)
             .white())
      return true;
  }
  return false;
}

// Signals that are derived get the resolution that these records allow, and all signals the noise that they have.
void fit_signals_to(const std::vector<Record>& records, const std::vector<rig_file::ChannelCalibration>& calibrations,
                    firmware::CoreConfiguration& configuration) {
  if (!rig_file::filtered(configuration) && !coloured_displacement(records, calibrations)) return;
  std::vector<std::vector<firmware::RawSample>> samples;
  for (const Record& record : records) {
    RecordSampleSource source(record, calibrations);
    samples.emplace_back(record.samples());
    for (firmware::RawSample& sample : samples.back()) source.read(sample);
  }
  rig_file::plan_signals(configuration,
                         rig_file::measure_ranges(configuration, samples, rig_file::Corner::kBelowMotion));
}

}  // namespace

firmware::CoreConfiguration configuration_for(const rig_file::RigModel& model, const std::vector<Record>& records,
                                              const std::vector<rig_file::ChannelCalibration>& calibrations,
                                              std::optional<double> excitation_Hz) {
  firmware::CoreConfiguration configuration =
      rig_file::compile_rig(model, records.front().sample_period_s, calibrations);
  fit_signals_to(records, calibrations, configuration);
  configuration.window = window_of(records, excitation_Hz);
  configuration.probe_products_per_sample = firmware::kAllProbes;  // no next sample waits
  configuration.corrects_channels = false;                         // see correct_channels()
  return configuration;
}

}  // namespace host_sim
