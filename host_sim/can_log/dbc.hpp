// The frame table as a DBC, the file that CAN tools load: little-endian integer signals, no multiplexing, no floats.
#pragma once
#include <ostream>
#include <string>
#include <vector>

namespace can_log {

// Every frame of every node, DOF and estimate. With names ("viscous[1-2]", in the order of the estimates) only as many
// estimates as there are names, each with its name in its comment.
void dbc(std::ostream& output, const std::vector<std::string>& parameter_names = {});

}  // namespace can_log
