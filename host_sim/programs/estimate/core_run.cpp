#include "host_sim/programs/estimate/core_run.hpp"

#include <cmath>
#include <memory>
#include <sstream>

#include "firmware/identification/rows/backward_time.hpp"
#include "hal/rig_file/signal_plan.hpp"
#include "host_sim/can_log/log_writer.hpp"
#include "host_sim/programs/estimate/from_its_end.hpp"
#include "host_sim/programs/estimate/records_configuration.hpp"
#include "host_sim/records/digitise.hpp"
#include "host_sim/records/record_checks.hpp"
#include "host_sim/virtual_rig/board_configuration.hpp"
#include "host_sim/virtual_rig/replay_board.hpp"

namespace host_sim {
namespace {

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

}  // namespace

Estimation run_core(const rig_file::RigModel& model, const std::vector<Record>& records,
                    const EstimationOptions& options, bool from_end) {
  const std::vector<rig_file::ChannelCalibration> calibrations = calibrate(records, model);
  firmware::CoreConfiguration configuration = configuration_for(model, records, calibrations, options.excitation_Hz);
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

}  // namespace host_sim
