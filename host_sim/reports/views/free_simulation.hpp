// A rig running freely beside its records.
#pragma once
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim::reports {

// Each record from a fitted start (fitted_start.hpp) to its end. Empty where the rig cannot run freely (a DOF without mass) or the
// integration fails, which a note then says.
std::vector<Record> simulate_all(const rig_file::RigModel& rig, const std::vector<Record>& records,
                                 std::vector<std::string>& notes);

// The record whose motion the simulation misses most: largest sum over DOFs of squared error over variance, of the
// fastest quantity that is measured. 0 without simulations.
size_t worst_record(const std::vector<Record>& records, const std::vector<Record>& simulated);

}  // namespace host_sim::reports
