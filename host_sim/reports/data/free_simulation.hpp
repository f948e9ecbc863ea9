// A rig running freely beside a record, restarted from the measured state now and then.
#pragma once
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim::reports {

// Displacement, velocity and acceleration of every DOF for all samples of the record; the state is the measured one at
// each sample of `starts` (ascending, the first 0). Throws PlantError.
Record simulate_from(const rig_file::RigModel& rig, const Record& record, const std::vector<size_t>& starts);

}  // namespace host_sim::reports
