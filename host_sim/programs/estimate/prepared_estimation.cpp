#include "host_sim/programs/estimate/prepared_estimation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "hal/rig_file/compile_rig.hpp"
#include "host_sim/programs/estimate/ac_coupled.hpp"
#include "host_sim/programs/estimate/accelerometer_zero.hpp"
#include "host_sim/programs/estimate/long_delays.hpp"
#include "host_sim/programs/estimate/oversampling.hpp"
#include "host_sim/programs/shared/rest_balance.hpp"
#include "host_sim/programs/shared/rest_position.hpp"
#include "host_sim/programs/shared/slow_drift.hpp"

namespace host_sim {

namespace {

size_t valid(const Estimation& estimation) {
  const auto& p = estimation.result.parameters;
  return static_cast<size_t>(std::count_if(
      p.begin(), p.end(), [](const ParameterResult& one) { return one.status == firmware::EstimateStatus::kValid; }));
}

// Of two preparations of the same records: which suspects nothing, warrants more, and else which the records scatter less about. A zero
// that is elsewhere than it is counted from scatters, on either side.
bool better(const Estimation& one, const Estimation& other) {
  const bool suspicious = suspects(one.result.warrant);
  if (suspicious != suspects(other.result.warrant)) return !suspicious;
  if (valid(one) != valid(other)) return valid(one) > valid(other);
  double ratio = 0.0;
  for (size_t k = 0; k < one.result.parameters.size(); ++k)
    ratio += std::log(one.result.parameters[k].std / other.result.parameters[k].std);
  return ratio < 0.0;
}

// What the core is given, and what it answers.
struct Prepared {
  rig_file::RigModel model;
  SharedRecords records;
  std::vector<std::string> notes;
  Estimation estimation;
};

// Where the forces say that it rests elsewhere it is estimated once more from there.
void balance(MeanOf of, const std::vector<size_t>& channels, const EstimationOptions& options, Prepared& prepared) {
  if (channels.empty()) return;
  Prepared balanced = prepared;
  const rig_file::RigModel rig = rig_file::with_values(balanced.model, values_of(balanced.estimation.result));
  if (!balance_rest(of, rig, channels, balanced.records)) return;
  balanced.estimation = estimate_records(balanced.model, balanced.records.get(), options);
  if (of == MeanOf::kDriven || better(balanced.estimation, prepared.estimation)) prepared = std::move(balanced);
}

// rest: what has been taken off its records.
void estimate_counted(const CountedFromRest& rest, const EstimationOptions& options, Prepared& prepared) {
  for (const auto& told : {rest.notes, take_off_accelerometer_zeros(prepared.records)})
    prepared.notes.insert(prepared.notes.end(), told.begin(), told.end());
  prepared.estimation = estimate_records(prepared.model, prepared.records.get(), options);
  balance(MeanOf::kDriven, rest.held_off, options, prepared);
  balance(MeanOf::kFreeMotion, rest.swinging, options, prepared);
}

void estimate_as_recorded(const EstimationOptions& options, Prepared& prepared) {
  auto& [model, records, notes, estimation] = prepared;
  if (const std::string told = take_fewer_samples(model, records); !told.empty()) notes.push_back(told);
  const Drift drift = drift_of(DriftOf::kIntegrated, model, records.get());
  if (drift.end_Hz > 0.0) take_off(DriftOf::kIntegrated, drift, records.own()), notes.push_back(said_of(drift));
  std::optional<Prepared> shifted = prepared;
  const CountedFromRest all = count_from_rest(CentreOf::kFreeSwings, model, shifted->records);
  const CountedFromRest once = count_from_rest(CentreOf::kOneSide, model, records);
  if (all.notes == once.notes) shifted.reset();
  estimate_counted(once, options, prepared);
  if (!shifted) return;
  estimate_counted(all, options, *shifted);
  if (better(shifted->estimation, estimation)) prepared = std::move(*shifted);
}

}  // namespace

Estimation estimate_prepared(rig_file::RigModel& model, SharedRecords& records, const EstimationOptions& options,
                             std::vector<std::string>& notes) {
  for (const std::string& told : undo_shown_ac_couplings(records)) notes.push_back(told);
  if (const std::string told = take_out_long_delays(model, records); !told.empty()) notes.push_back(told);
  const Drift drift = drift_of(DriftOf::kDisplacements, model, records.get());
  Prepared prepared{model, std::move(records), notes, {}};
  std::optional<Prepared> without;
  if (drift.end_Hz > 0.0) without = prepared;  // who holds the records has them copied
  estimate_as_recorded(options, prepared);
  if (without && valid(prepared.estimation) < prepared.estimation.result.parameters.size()) {
    take_off(DriftOf::kDisplacements, drift, without->records.own());
    without->notes.push_back(said_of(drift));
    estimate_as_recorded(options, *without);
    if (!suspects(without->estimation.result.warrant) && valid(without->estimation) > valid(prepared.estimation))
      prepared = std::move(*without);
  }
  model = std::move(prepared.model), records = std::move(prepared.records), notes = std::move(prepared.notes);
  return std::move(prepared.estimation);
}

}  // namespace host_sim
