#include "host_sim/programs/estimate/estimation.hpp"

#include <optional>
#include <string>
#include <utility>

#include "host_sim/programs/estimate/channel_correction.hpp"
#include "host_sim/programs/estimate/channel_pairs.hpp"
#include "host_sim/programs/estimate/core_run.hpp"
#include "host_sim/programs/estimate/from_its_end.hpp"
#include "host_sim/programs/results/fit_quality.hpp"
#include "host_sim/programs/shared/failures.hpp"
#include "host_sim/records/files/data_file_error.hpp"
#include "host_sim/records/parts_kept.hpp"
#include "host_sim/records/record_checks.hpp"
#include "host_sim/vocabulary/held_in_place.hpp"

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

Estimation estimate_as_told(const rig_file::RigModel& model, const std::vector<Record>& records,
                            const EstimationOptions& options) {
  if (!begins_in_motion(model, records)) return run_core(model, records, options, false);
  Estimation estimation = run_core(backwards(model), backwards(records), options, true);
  estimation.result.notes.push_back(
      std::string(
          "nothing drives the rig and not all of its displacements are measured: the records are read from their "
          "end, where the motion that is integrated ") +
      (vocabulary::held_in_place(model) ? "has come to rest" : "is slowest"));
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
  tell_corrections(corrections, records, corrected.result);
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
