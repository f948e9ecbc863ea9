// A channel that says something else than the other channels of its DOF.
#pragma once
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace diagnosis {

// Names of the channels of this quantity at DOFs that have another channel of motion too.
std::vector<std::string> spared_by_others(const host_sim::Record& record, host_sim::Quantity quantity);

// Whether channels tell what the others of their DOFs tell: then it is not they that a rig file cannot describe.
bool go_with_the_others(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& records,
                        const std::vector<std::string>& names);

// The records without these channels.
std::vector<host_sim::Record> without_channels(std::vector<host_sim::Record> records,
                                               const std::vector<std::string>& names);

}  // namespace diagnosis
