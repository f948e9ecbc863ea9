#include "host_sim/programs/estimate/by_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "host_sim/can_log/readable.hpp"
#include "host_sim/programs/estimate/estimation.hpp"
#include "host_sim/programs/shared/failures.hpp"

namespace host_sim {
namespace {

constexpr double kMatters = 0.05;  // what the warrant calls wrong
// What the warrant calls wrong is over four quoted deviations off; those of single records are of few windows.
constexpr double kDeviations = 5.0;
constexpr double kOfInterval = 1.96;

using firmware::EstimateStatus;

// Of one record alone; an interval of few windows is wider than its standard deviation says.
struct OfRecord {
  size_t record = 0;
  double value = 0.0, half = 0.0;
};

std::string number(const OfRecord& one) {
  return can_log::rounded_to(one.value, one.half) + " +- " + fmt::format("{:.2g}", one.half);
}

bool contradict(const OfRecord& low, const OfRecord& high) {
  const double apart = high.value - low.value;
  return apart > kMatters * std::max(std::abs(low.value), std::abs(high.value)) &&
         apart > kDeviations / kOfInterval * std::hypot(low.half, high.half);
}

// One record alone can seldom test the rig file.
bool holds_in_its_model(EstimateStatus status) {
  return status == EstimateStatus::kValid || status == EstimateStatus::kUntested;
}

bool wide(const ParameterResult& p) {
  return p.has_interval() && 0.5 * (p.ci95_high - p.ci95_low) > kMatters * std::abs(p.value);
}

// The results of every record that can be estimated alone.
std::vector<EstimateResult> one_by_one(const rig_file::RigModel& model, const std::vector<Record>& records,
                                       std::vector<size_t>& of) {
  std::vector<EstimateResult> results;
  EstimationOptions options;
  options.frames = false;
  for (size_t r = 0; r < records.size(); ++r) {
    try {
      results.push_back(estimate_records(model, {records[r]}, options).result);
      of.push_back(r);
    } catch (const CannotAnswer&) {  // too short by itself
    }
  }
  return results;
}

}  // namespace

void doubt_what_records_contradict(const rig_file::RigModel& model, const std::vector<Record>& records,
                                   EstimateResult& result) {
  if (records.size() < 2 || std::none_of(result.parameters.begin(), result.parameters.end(), wide)) return;
  std::vector<size_t> of;
  const std::vector<EstimateResult> alone = one_by_one(model, records, of);
  std::string told;
  for (size_t k = 0; k < result.parameters.size(); ++k) {
    std::vector<OfRecord> said;
    for (size_t i = 0; i < alone.size(); ++i) {
      const ParameterResult& p = alone[i].parameters[k];
      if (holds_in_its_model(p.status)) said.push_back({of[i], p.value, 0.5 * (p.ci95_high - p.ci95_low)});
    }
    if (said.size() < 2) continue;
    const auto [low, high] = std::minmax_element(
        said.begin(), said.end(), [](const OfRecord& one, const OfRecord& two) { return one.value < two.value; });
    if (!contradict(*low, *high)) continue;
    ParameterResult& p = result.parameters[k];
    told += fmt::format("{}{} is {} in {} and {} in {}", told.empty() ? "" : "; ", p.info.name, number(*low),
                        records[low->record].file, number(*high), records[high->record].file);
    const bool missed = low->value + low->half < p.ci95_low || high->value - high->half > p.ci95_high;
    if (missed && p.status == EstimateStatus::kValid) p.status = EstimateStatus::kModelSuspect;
  }
  if (told.empty()) return;
  result.records_contradict = true;
  result.notes.push_back("the records contradict each other: " + told +
                         "; estimate them apart, or look at what changed from one to the other: its amplitude (a law "
                         "that the rig file lacks), its temperature, the rig itself");
}

}  // namespace host_sim
