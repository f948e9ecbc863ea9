// Channels of one DOF beside each other: displacement, velocity and acceleration of one motion must agree, whatever the
// rig is (comparison.hpp).
#pragma once
#include <vector>

#include "host_sim/data_check/data_check.hpp"
#include "host_sim/data_check/one_motion/integrals.hpp"

namespace host_sim::data_check {

// Polarity, unit and lateness of the channels of one DOF (or of the base); lateness beyond what the rig file states. model: nothing
// where there is no rig file.
std::vector<Finding> check_kinematics(const Record& record, int dof, bool rotating, const rig_file::RigModel* model,
                                      Integrals& integrals);

}  // namespace host_sim::data_check
