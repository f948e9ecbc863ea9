// Free motions whose displacement is integrated: the core reads them from their end, where they rest (firmware/identification/rows/backward_time.hpp).
#pragma once
#include <vector>

#include "firmware/configuration/configuration.hpp"
#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// Nothing drives the rig, some DOF has no displacement, and every force of the rig file is known from place and rate alone (what
// remembers is another force backwards).
bool begins_in_motion(const rig_file::RigModel& model, const std::vector<Record>& records);

// The last sample first, velocities turned over.
std::vector<Record> backwards(const std::vector<Record>& records);
// A channel that is late is early.
rig_file::RigModel backwards(rig_file::RigModel model);
// Dampers and friction that the rig file gives push.
void run_back(firmware::CoreConfiguration& configuration);

}  // namespace host_sim
