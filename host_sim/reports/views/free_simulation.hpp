// A rig running freely beside its records.
#pragma once
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim::reports {

// Displacement, velocity and acceleration of every DOF for all samples of the record; the state is the measured one at
// each sample of `starts` (ascending, the first 0). Throws PlantError.
Record simulate_from(const rig_file::RigModel& rig, const Record& record, const std::vector<size_t>& starts);

// Each record from its own initial state to its end. Empty where the rig cannot run freely (a DOF without mass) or the
// integration fails, which a note then says.
std::vector<Record> simulate_all(const rig_file::RigModel& rig, const std::vector<Record>& records,
                                 std::vector<std::string>& notes);

// The record whose motion the simulation misses most: largest sum over DOFs of squared error over variance, of the
// fastest quantity that is measured. 0 without simulations.
size_t worst_record(const std::vector<Record>& records, const std::vector<Record>& simulated);

}  // namespace host_sim::reports
