#include "host_sim/programs/diagnose/driven_records.hpp"

#include <algorithm>
#include <optional>

#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/rig_file_error.hpp"
#include "host_sim/programs/estimate/estimation.hpp"
#include "host_sim/programs/shared/any_force.hpp"
#include "host_sim/programs/shared/failures.hpp"
#include "host_sim/programs/shared/rest_balance.hpp"
#include "host_sim/programs/shared/rest_position.hpp"
#include "host_sim/programs/shared/turned_force.hpp"
#include "host_sim/records/files/data_file_error.hpp"
#include "host_sim/vocabulary/held_in_place.hpp"

namespace host_sim {
namespace {

// Nothing where these records do not tell.
std::optional<EstimateResult> estimates_of(const rig_file::RigModel& rig, const std::vector<Record>& records) {
  EstimationOptions options;
  options.frames = false;
  try {
    return estimate_records(rig, records, options).result;
  } catch (const CannotAnswer&) {
  } catch (const DataFileError&) {
  } catch (const rig_file::RigFileError&) {
  }
  return std::nullopt;
}

void balance(const rig_file::RigModel& rig, const std::vector<size_t>& channels, SharedRecords& records) {
  if (rig_file::parameter_names(rig).empty()) {
    balance_rest(MeanOf::kDriven, rig, channels, records);
    return;
  }
  const auto found = estimates_of(rig, records.get());
  if (found) balance_rest(MeanOf::kDriven, rig_file::with_values(rig, values_of(*found)), channels, records);
}

}  // namespace

std::vector<std::string> count_forced_from_rest(const rig_file::RigModel& rig, std::vector<Record>& training,
                                                std::vector<Record>& unseen) {
  if (!any_force(training) || vocabulary::massless(rig)) return {};
  SharedRecords records(training);
  const CountedFromRest rest = count_from_rest(CentreOf::kOneSide, rig, records);
  if (rest.held_off.empty()) return {};
  balance(rig, rest.held_off, records);
  for (const size_t c : rest.held_off) {
    const double zero = training.front().channels[c].values[0] - records.get().front().channels[c].values[0];
    for (std::vector<Record>* list : {&training, &unseen})
      for (Record& record : *list)
        for (double& value : record.channels[c].values) value -= zero;
  }
  return rest.notes;
}

std::string turn_forces_round(const rig_file::RigModel& rig, std::vector<Record>& training,
                              std::vector<Record>& unseen) {
  if (!may_be_turned(rig, training)) return "";
  const auto found = estimates_of(rig, training);
  if (!found || !says_turned(*found)) return "";
  turn_forces(unseen);
  return turn_forces(training);
}

}  // namespace host_sim
