// Forces that are turned over, where the rig file knows no mass and no spring that would say so.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/programs/results/estimate_result.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// Whether a turned force would leave the equations of motion as they are, but for the signs of all estimates: masses, springs and
// gravity torques are unknown or none, at least one mass is unknown, and a force is measured.
bool may_be_turned(const rig_file::RigModel& rig, const std::vector<Record>& records);

// Every unknown mass is below nought by four deviations, and no unknown spring above it: no rig is like that, and with the forces' sign
// changed none is. Without an unknown mass a spring has to be below it.
bool says_turned(const EstimateResult& result);

// Changes the sign of every force. Returns what to say of them.
std::string turn_forces(std::vector<Record>& records);

}  // namespace host_sim
