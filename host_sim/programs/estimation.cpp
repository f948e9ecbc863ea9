#include "host_sim/programs/estimation.hpp"

#include <cmath>
#include <memory>
#include <sstream>

#include "hal/configuration/signal_plan.hpp"
#include "host_sim/can_log/log_writer.hpp"
#include "host_sim/programs/estimate_frames.hpp"
#include "host_sim/programs/failures.hpp"
#include "host_sim/programs/fit_quality.hpp"
#include "host_sim/records/data_file_error.hpp"
#include "host_sim/records/digitise.hpp"
#include "host_sim/records/record_checks.hpp"

namespace host_sim {
namespace {

constexpr size_t kFewestSamples = 4 * firmware::kBlockSamples;

void check_records(const std::vector<Record>& records) {
  require_same_channels(records);
  if (records.size() > firmware::kMaxLevels)
    throw DataFileError(records[firmware::kMaxLevels].file, 0,
                        "is data file " + std::to_string(firmware::kMaxLevels + 1) + ", expected at most " +
                            std::to_string(firmware::kMaxLevels));
  for (const Record& record : records)
    if (record.samples() < kFewestSamples)
      throw CannotAnswer(record.file + " holds " + std::to_string(record.samples()) +
                         " samples, too few for any window; record at least " + std::to_string(kFewestSamples) +
                         ", several cycles of the lowest frequency");
}

bool has_force(const Record& record) {
  for (const Channel& channel : record.channels)
    if (channel.quantity == Quantity::kForce || channel.dof == rig_file::kBase) return true;
  return false;
}

firmware::WindowConfiguration window_of(const Record& record, const EstimationOptions& options) {
  firmware::WindowConfiguration window;
  window.mode = has_force(record) ? firmware::WindowMode::kInterval : firmware::WindowMode::kFreeDecay;
  if (!options.excitation_Hz) return window;
  constexpr uint32_t kDenominator = 1u << 16;
  const double cycle_samples = 1.0 / (*options.excitation_Hz * record.sample_period_s);
  if (!(cycle_samples >= 4.0) || cycle_samples > static_cast<double>(record.samples()))
    throw UsageError("--frequency is " + std::to_string(*options.excitation_Hz) +
                     " Hz, expected a cycle of 4 samples to the length of " + record.file);
  window.mode = firmware::WindowMode::kWholeCycles;
  window.cycle_samples_numerator = static_cast<uint32_t>(std::llround(cycle_samples * kDenominator));
  window.cycle_samples_denominator = kDenominator;
  return window;
}

// Signals that are derived get the resolution that these records allow.
void fit_signals_to(const std::vector<Record>& records, const std::vector<rig_file::ChannelCalibration>& calibrations,
                    firmware::CoreConfiguration& configuration) {
  std::vector<std::vector<firmware::RawSample>> samples;
  for (const Record& record : records) {
    RecordSampleSource source(record, calibrations);
    samples.emplace_back(record.samples());
    for (firmware::RawSample& sample : samples.back()) source.read(sample);
  }
  rig_file::plan_signals(configuration, rig_file::measure_ranges(configuration, samples));
}

// Feeds the records and lets the frames follow: a heartbeat every 100 ms, a window every second.
class Feed {
 public:
  Feed(firmware::EstimatorCore& core, EstimateFrames& frames, const EstimationOptions& options, size_t total)
      : core_(core), frames_(frames), options_(options), total_(total) {}

  void record(const Record& record, const std::vector<rig_file::ChannelCalibration>& calibrations) {
    RecordSampleSource source(record, calibrations);
    firmware::RawSample sample;
    core_.begin_level();
    while (source.read(sample) == hal::SampleResult::kSample) {
      core_.push(sample);
      after_sample(record.sample_period_s);
    }
    core_.end_level();
  }
  uint64_t time_ns() const { return time_ns_; }

 private:
  static constexpr uint64_t kHeartbeat_ns = 100000000, kWindow_ns = 1000000000;

  void after_sample(double period_s) {
    const uint64_t before_ns = time_ns_;
    time_ns_ = static_cast<uint64_t>(std::llround(static_cast<double>(++done_) * period_s * 1e9));
    if (time_ns_ / kHeartbeat_ns != before_ns / kHeartbeat_ns) frames_.heartbeat(time_ns_);
    if (time_ns_ / kWindow_ns == before_ns / kWindow_ns) return;
    frames_.window(time_ns_, core_.solve(), core_.health(), false);
    if (options_.progress) options_.progress(static_cast<double>(done_) / static_cast<double>(total_));
  }

  firmware::EstimatorCore& core_;
  EstimateFrames& frames_;
  const EstimationOptions& options_;
  size_t total_, done_ = 0;
  uint64_t time_ns_ = 0;
};

}  // namespace

Estimation estimate_records(const rig_file::RigModel& model, const std::vector<Record>& records,
                            const EstimationOptions& options) {
  check_records(records);
  const std::vector<rig_file::ChannelCalibration> calibrations = calibrate(records, model);
  firmware::CoreConfiguration configuration =
      rig_file::compile_rig(model, records.front().sample_period_s, calibrations);
  fit_signals_to(records, calibrations, configuration);
  configuration.window = window_of(records.front(), options);
  const auto core = std::make_unique<firmware::EstimatorCore>(configuration);
  std::ostringstream log_text;
  can_log::LogWriter log(log_text, "can0");
  EstimateFrames frames([&log](const firmware::CanMessage& message, uint64_t time_ns) { log.write(message, time_ns); });
  frames.begin(model, configuration);
  size_t samples = 0;
  for (const Record& record : records) samples += record.samples();
  Feed feed(*core, frames, options, samples);
  for (const Record& record : records) feed.record(record, calibrations);
  const firmware::Estimates& estimates = core->solve();
  frames.window(feed.time_ns(), estimates, core->health(), true);

  Estimation estimation;
  estimation.result = result_of(model, estimates);
  estimation.result.samples = samples;
  estimation.result.sample_rate_Hz = 1.0 / records.front().sample_period_s;
  estimation.result.levels = static_cast<unsigned>(records.size());
  estimation.result.health = core->health();
  if (const std::string plan = rig_file::describe_plan(configuration); !plan.empty())
    estimation.result.notes.push_back(plan);
  for (const std::string& name : rig_file::simulator_only_effects(model))
    estimation.result.notes.push_back(name + " is known to the simulator only; the energy equations leave it out");
  judge_fit(model, records, estimation.result);
  estimation.frames = log_text.str();
  return estimation;
}

}  // namespace host_sim
