#include "host_sim/programs/estimate/prepared_estimation.hpp"

#include <algorithm>

#include "hal/rig_file/compile_rig.hpp"
#include "host_sim/programs/estimate/accelerometer_zero.hpp"
#include "host_sim/programs/estimate/oversampling.hpp"
#include "host_sim/programs/shared/rest_balance.hpp"
#include "host_sim/programs/shared/rest_position.hpp"
#include "host_sim/programs/shared/slow_drift.hpp"

namespace host_sim {

namespace {

Estimation estimate_as_recorded(rig_file::RigModel& model, SharedRecords& records, const EstimationOptions& options,
                                std::vector<std::string>& notes) {
  if (const std::string told = take_fewer_samples(model, records); !told.empty()) notes.push_back(told);
  const Drift drift = drift_of(DriftOf::kIntegrated, model, records.get());
  if (drift.end_Hz > 0.0) take_off(DriftOf::kIntegrated, drift, records.own()), notes.push_back(said_of(drift));
  const CountedFromRest rest = count_from_rest(model, records);
  for (const auto& told : {rest.notes, take_off_accelerometer_zeros(records)})
    notes.insert(notes.end(), told.begin(), told.end());
  Estimation estimation = estimate_records(model, records.get(), options);
  if (balance_rest(rig_file::with_values(model, values_of(estimation.result)), rest.held_off, records))
    estimation = estimate_records(model, records.get(), options);
  return estimation;
}

size_t valid(const Estimation& estimation) {
  const auto& p = estimation.result.parameters;
  return static_cast<size_t>(std::count_if(
      p.begin(), p.end(), [](const ParameterResult& one) { return one.status == firmware::EstimateStatus::kValid; }));
}

}  // namespace

Estimation estimate_prepared(rig_file::RigModel& model, SharedRecords& records, const EstimationOptions& options,
                             std::vector<std::string>& notes) {
  const Drift drift = drift_of(DriftOf::kDisplacements, model, records.get());
  rig_file::RigModel other_model = model;
  SharedRecords without = drift.end_Hz > 0.0 ? records : SharedRecords({});  // who holds them has them copied
  const std::vector<std::string> before = notes;
  Estimation estimation = estimate_as_recorded(model, records, options, notes);
  if (drift.end_Hz == 0.0 || valid(estimation) == estimation.result.parameters.size()) return estimation;
  take_off(DriftOf::kDisplacements, drift, without.own());
  std::vector<std::string> other_notes = before;
  other_notes.push_back(said_of(drift));
  Estimation other = estimate_as_recorded(other_model, without, options, other_notes);
  if (suspects(other.result.warrant) || valid(other) <= valid(estimation)) return estimation;
  model = other_model, records = without, notes = other_notes;
  return other;
}

}  // namespace host_sim
