// A rig that rides on its base.
#pragma once
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace diagnosis {

bool touches_ground(const rig_file::RigModel& rig);

// Whether it touches no ground, and its base is measured.
bool on_measured_base(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& records);

bool base_runs_on(const std::vector<host_sim::Record>& records);

// Of such a rig: no law knows where and how fast all of it is. Where its base runs on (a shaft that turns), motion counts from that; and
// the base's place from its mean, where no DOF's is measured.
std::vector<host_sim::Record> riding(const rig_file::RigModel& rig, std::vector<host_sim::Record> records);

}  // namespace diagnosis
