#include "host_sim/programs/estimate/estimation.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

#include "firmware/identification/backward_time.hpp"
#include "hal/rig_file/first_batches.hpp"
#include "hal/rig_file/recorded/channel_noise.hpp"
#include "hal/rig_file/signal_plan.hpp"
#include "host_sim/can_log/log_writer.hpp"
#include "host_sim/programs/estimate/channel_correction.hpp"
#include "host_sim/programs/estimate/channel_pairs.hpp"
#include "host_sim/programs/estimate/from_its_end.hpp"
#include "host_sim/programs/results/fit_quality.hpp"
#include "host_sim/programs/shared/failures.hpp"
#include "host_sim/records/digitise.hpp"
#include "host_sim/records/files/data_file_error.hpp"
#include "host_sim/records/parts_kept.hpp"
#include "host_sim/records/record_checks.hpp"
#include "host_sim/virtual_rig/board_configuration.hpp"
#include "host_sim/virtual_rig/replay_board.hpp"

namespace host_sim {
namespace {

void check_records(const std::vector<Record>& records) {
  require_same_channels(records);
  if (records.size() > firmware::kMaxLevels)
    throw DataFileError(records[firmware::kMaxLevels].file, 0,
                        "is data file " + std::to_string(firmware::kMaxLevels + 1) + ", expected at most " +
                            std::to_string(firmware::kMaxLevels));
  for (const Record& record : records)
    if (record.samples() < kFewestOfPart)
      throw CannotAnswer(record.file + " holds " + std::to_string(record.samples()) +
                         " samples, too few for any window; record at least " + std::to_string(kFewestOfPart) +
                         ", several cycles of the lowest frequency");
}

firmware::WindowConfiguration window_of(const std::vector<Record>& records, const EstimationOptions& options) {
  const Record& record = records.front();
  firmware::WindowConfiguration window;
  window.mode = has_drive(record) ? firmware::WindowMode::kInterval : firmware::WindowMode::kFreeDecay;
  if (!options.excitation_Hz) {
    size_t shortest = record.samples();
    for (const Record& other : records) shortest = std::min(shortest, other.samples());
    window.batch_samples = rig_file::first_batch_samples(shortest);
    return window;
  }
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

// The records one after the other, one level each, as a board's core takes them: as fast as it can, and one solve at the end.
class CoreAlone {
 public:
  explicit CoreAlone(const firmware::CoreConfiguration& configuration)
      : core_(std::make_unique<firmware::EstimatorCore>(configuration)) {}

  void begin_level() { core_->begin_level(); }
  void push(const firmware::RawSample& sample, uint64_t) { core_->push(sample); }
  void end_level() { core_->end_level(); }
  void finish(uint64_t) { core_->solve(); }

  const firmware::EstimatorCore& core() const { return *core_; }
  const firmware::Estimates& estimates() const { return core_->estimates(); }

 private:
  std::unique_ptr<firmware::EstimatorCore> core_;  // large: not for the stack
};

// The same on a whole board of fakes, the frames of its controller into a log.
class WholeBoard {
 public:
  explicit WholeBoard(const firmware::ControllerConfiguration& configuration)
      : log_(text_, "can0"), board_(configuration, [this](const hal::CanFrame& frame) { log_.write(frame); }) {
    board_.run_at(0);
  }

  void begin_level() { board_.begin_level(); }
  void push(const firmware::RawSample& sample, uint64_t time_ns) { board_.push(sample, time_ns); }
  void end_level() { board_.end_level(); }
  // One more heartbeat and status, which says DONE.
  void finish(uint64_t time_ns) {
    board_.finish(time_ns);
    board_.run_at(time_ns + kHeartbeat_ns);
  }

  const firmware::EstimatorCore& core() const { return board_.core(); }
  const firmware::Estimates& estimates() const { return *board_.controller().estimates(); }
  std::string frames() const { return text_.str(); }

 private:
  static constexpr uint64_t kHeartbeat_ns = 100000000;

  std::ostringstream text_;
  can_log::LogWriter log_;
  ReplayBoard board_;
};

size_t samples_of(const std::vector<Record>& records) {
  size_t samples = 0;
  for (const Record& record : records) samples += record.samples();
  return samples;
}

template <typename Target>
void feed(const std::vector<Record>& records, const std::vector<rig_file::ChannelCalibration>& calibrations,
          const EstimationOptions& options, Target& target) {
  constexpr size_t kProgressSamples = 4096;
  const size_t total = samples_of(records);
  size_t done = 0;
  uint64_t time_ns = 0;
  for (const Record& record : records) {
    RecordSampleSource source(record, calibrations);
    firmware::RawSample sample;
    target.begin_level();
    while (source.read(sample) == hal::SampleResult::kSample) {
      sample.sequence = static_cast<uint32_t>(done++);  // between two records nothing is missed
      time_ns = static_cast<uint64_t>(std::llround(static_cast<double>(done) * record.sample_period_s * 1e9));
      target.push(sample, time_ns);
      if (done % kProgressSamples == 0 && options.progress)
        options.progress(static_cast<double>(done) / static_cast<double>(total));
    }
    target.end_level();
  }
  target.finish(time_ns);
}

// The configuration of the core for these records.
firmware::CoreConfiguration configuration_for(const rig_file::RigModel& model, const std::vector<Record>& records,
                                              const std::vector<rig_file::ChannelCalibration>& calibrations,
                                              const EstimationOptions& options) {
  firmware::CoreConfiguration configuration =
      rig_file::compile_rig(model, records.front().sample_period_s, calibrations);
  fit_signals_to(records, calibrations, configuration);
  configuration.window = window_of(records, options);
  configuration.probe_products_per_sample = firmware::kAllProbes;  // no next sample waits
  configuration.corrects_channels = false;                         // see correct_channels()
  return configuration;
}

template <typename Target>
EstimateResult result_from(const rig_file::RigModel& model, const std::vector<Record>& records,
                           const firmware::CoreConfiguration& configuration, const Target& target) {
  EstimateResult result = result_of(model, target.estimates(), records);
  result.covariance = covariance_of(result, target.core());
  const auto turned = [&](size_t k) { return firmware::turns_over(configuration, static_cast<int>(k)); };
  for (size_t i = 0; i < result.covariance.size(); ++i)
    for (size_t j = 0; j < result.covariance.size(); ++j)
      if (turned(i) != turned(j)) result.covariance[i][j] = -result.covariance[i][j];
  result.samples = samples_of(records);
  result.sample_rate_Hz = 1.0 / records.front().sample_period_s;
  result.levels = static_cast<unsigned>(records.size());
  result.integrates = configuration.high_pass_order > 0;
  result.health = target.core().health();
  if (const std::string plan = rig_file::describe_plan(configuration); !plan.empty()) result.notes.push_back(plan);
  for (const std::string& name : rig_file::simulator_only_effects(model))
    result.notes.push_back(name + " is known to the simulator only; the energy equations leave it out");
  return result;
}

// from_end: the records come last sample first.
Estimation estimate_in_order(const rig_file::RigModel& model, const std::vector<Record>& records,
                             const EstimationOptions& options, bool from_end) {
  const std::vector<rig_file::ChannelCalibration> calibrations = calibrate(records, model);
  firmware::CoreConfiguration configuration = configuration_for(model, records, calibrations, options);
  if (from_end) run_back(configuration);
  Estimation estimation;
  if (!options.frames) {
    CoreAlone core(configuration);
    feed(records, calibrations, options, core);
    estimation.result = result_from(model, records, configuration, core);
    return estimation;
  }
  WholeBoard board(board_configuration(model, configuration, records.front().sample_period_s));
  feed(records, calibrations, options, board);
  estimation.result = result_from(model, records, configuration, board);
  estimation.frames = board.frames();
  return estimation;
}

Estimation estimate_as_told(const rig_file::RigModel& model, const std::vector<Record>& records,
                            const EstimationOptions& options) {
  if (!begins_in_motion(model, records)) return estimate_in_order(model, records, options, false);
  Estimation estimation = estimate_in_order(backwards(model), backwards(records), options, true);
  estimation.result.notes.push_back(
      "nothing drives the rig and not all of its displacements are measured: the records are read from their end, "
      "where the motion that is integrated has come to rest");
  return estimation;
}

// Several channels may be off, one showing where another has been corrected.
constexpr int kMostRounds = 3;

// The same with these corrections; what it says of them stands in its result.
Estimation estimate_corrected(const rig_file::RigModel& model, const std::vector<Record>& records,
                              const EstimationOptions& options, const std::vector<ChannelCorrection>& corrections) {
  std::vector<Record> scaled;
  if (any_gain(corrections)) scaled = without_gains(corrections, records);
  const std::vector<Record>& corrected_records = scaled.empty() ? records : scaled;
  Estimation corrected = estimate_as_told(with_delays(model, corrections), corrected_records, options);
  if (!corrections_hold(corrected.result, corrections, records)) return corrected;
  tell_corrections(corrections, corrected.result);
  corrected.simulated = judge_fit(model, corrected_records, corrected.result);
  return corrected;
}

// With the channels corrected that the estimation finds late or with another gain; nothing where the corrected records do not say
// that this was it.
std::optional<Estimation> correct_channels(const rig_file::RigModel& model, const std::vector<Record>& records,
                                           const EstimationOptions& options, const EstimateResult& first) {
  std::vector<ChannelCorrection> corrections = corrections_to_make(first, records, true);
  for (int round = 0; round < kMostRounds && !corrections.empty(); ++round) {
    Estimation corrected = estimate_corrected(model, records, options, corrections);
    if (!corrected.result.warrant.corrected.empty()) return corrected;
    const auto more = corrections_to_make(corrected.result, records, false);
    if (more.empty()) break;
    add_corrections(more, corrections);
  }
  return std::nullopt;
}

// Displacement and acceleration disagree, and the equations of motion bear one of them out alone.
std::optional<Estimation> correct_pair(const rig_file::RigModel& model, const std::vector<Record>& records,
                                       const EstimationOptions& options, const EstimateResult& first) {
  if (first.warrant.named.effect.empty()) return std::nullopt;
  std::optional<Estimation> borne_out;
  for (const ChannelCorrection& correction : pair_corrections(records)) {
    Estimation corrected = estimate_corrected(model, records, options, {correction});
    if (corrected.result.warrant.corrected.empty()) continue;
    if (borne_out) return std::nullopt;
    borne_out = std::move(corrected);
  }
  return borne_out;
}

}  // namespace

Estimation estimate_records(const rig_file::RigModel& model, const std::vector<Record>& records,
                            const EstimationOptions& options) {
  check_records(records);
  Estimation estimation = estimate_as_told(model, records, options);
  if (auto corrected = correct_channels(model, records, options, estimation.result)) return std::move(*corrected);
  if (auto corrected = correct_pair(model, records, options, estimation.result)) return std::move(*corrected);
  estimation.simulated = judge_fit(model, records, estimation.result);
  return estimation;
}

}  // namespace host_sim
