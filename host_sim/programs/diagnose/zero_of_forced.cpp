#include "host_sim/programs/diagnose/zero_of_forced.hpp"

#include <algorithm>
#include <utility>

#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/rig_file_error.hpp"
#include "host_sim/programs/estimate/estimation.hpp"
#include "host_sim/programs/shared/failures.hpp"
#include "host_sim/programs/shared/rest_balance.hpp"
#include "host_sim/programs/shared/rest_position.hpp"
#include "host_sim/records/data_file_error.hpp"

namespace host_sim {
namespace {

bool is_forced(const Record& record) {
  return std::any_of(record.channels.begin(), record.channels.end(),
                     [](const Channel& c) { return c.quantity == Quantity::kForce; });
}

bool has_mass(const rig_file::RigModel& rig) {
  return std::any_of(rig.dofs.begin(), rig.dofs.end(),
                     [](const rig_file::Dof& dof) { return dof.mass_kg.estimate || dof.mass_kg.value > 0; });
}

// With the numbers that the core finds in these records; as it is where nothing in it is unknown, or they do not tell.
rig_file::RigModel with_estimates(const rig_file::RigModel& rig, const std::vector<Record>& records) {
  if (rig_file::parameter_names(rig).empty()) return rig;
  EstimationOptions options;
  options.frames = false;
  return rig_file::with_values(rig, values_of(estimate_records(rig, records, options).result));
}

}  // namespace

std::vector<std::string> count_forced_from_rest(const rig_file::RigModel& rig, std::vector<Record>& training,
                                                std::vector<Record>& unseen) {
  if (!is_forced(training.front()) || !has_mass(rig)) return {};
  SharedRecords records(training);
  const CountedFromRest rest = count_from_rest(rig, records);
  if (rest.held_off.empty()) return {};
  try {
    balance_rest(with_estimates(rig, records.get()), rest.held_off, records);
  } catch (const CannotAnswer&) {  // counted from the mean, then
  } catch (const DataFileError&) {
  } catch (const rig_file::RigFileError&) {
  }
  for (const size_t c : rest.held_off) {
    const double zero = training.front().channels[c].values[0] - records.get().front().channels[c].values[0];
    for (std::vector<Record>* list : {&training, &unseen})
      for (Record& record : *list)
        for (double& value : record.channels[c].values) value -= zero;
  }
  return rest.notes;
}

}  // namespace host_sim
