// A channel that says something else than the other channels of its DOF.
#pragma once
#include <string>
#include <vector>

#include "host_sim/records/record.hpp"

namespace diagnosis {

// Names of the channels of this quantity at DOFs that have another channel of motion too.
std::vector<std::string> spared_by_others(const host_sim::Record& record, host_sim::Quantity quantity);

// The records without these channels.
std::vector<host_sim::Record> without_channels(std::vector<host_sim::Record> records,
                                               const std::vector<std::string>& names);

}  // namespace diagnosis
