// A rig that stands on a moving base of which only accelerations are known: seen from the base, under its inertial forces.
#pragma once
#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// Is nothing but accelerations known of the base and of every DOF, and does no link touch the ground? Displacement and velocity
// of the base are then neither known nor needed.
bool carried_by_base(const rig_file::RigModel& rig, const Record& record);

// The rig with the base in the place of the ground.
rig_file::RigModel seen_from_base(const rig_file::RigModel& rig);

// The forces of the record, less mass times acceleration of the base (N).
Record with_inertial_forces(const rig_file::RigModel& rig, const Record& record);

}  // namespace host_sim
