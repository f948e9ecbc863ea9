#include "host_sim/programs/estimate/prepared_estimation.hpp"

#include "hal/rig_file/compile_rig.hpp"
#include "host_sim/programs/estimate/accelerometer_zero.hpp"
#include "host_sim/programs/estimate/oversampling.hpp"
#include "host_sim/programs/estimate/slow_drift.hpp"
#include "host_sim/programs/shared/rest_balance.hpp"
#include "host_sim/programs/shared/rest_position.hpp"

namespace host_sim {

Estimation estimate_prepared(rig_file::RigModel& model, SharedRecords& records, const EstimationOptions& options,
                             std::vector<std::string>& notes) {
  for (const std::string& told : {take_fewer_samples(model, records), take_off_drift(model, records)})
    if (!told.empty()) notes.push_back(told);
  const CountedFromRest rest = count_from_rest(model, records);
  for (const auto& told : {rest.notes, take_off_accelerometer_zeros(records)})
    notes.insert(notes.end(), told.begin(), told.end());
  Estimation estimation = estimate_records(model, records.get(), options);
  if (balance_rest(rig_file::with_values(model, values_of(estimation.result)), rest.held_off, records))
    estimation = estimate_records(model, records.get(), options);
  return estimation;
}

}  // namespace host_sim
