// The frame table as a DBC, the file that CAN tools load: little-endian integer signals, no multiplexing. Floats stand
// in it only where the parameters are named.
#pragma once
#include <ostream>
#include <string>
#include <vector>

namespace can_log {

struct DbcParameter {
  std::string name;  // "viscous[1-2]"
  std::string unit;  // "N s/m"
};

// Every frame of every node, DOF and estimate. With parameters (in the order of the estimates) only as many estimates as
// there are of them, each with its name in its comment; and the frames of floats hold one float signal for the value
// (viscous_1_2) and one for the standard deviation (viscous_1_2_std), in the unit of the parameter.
void dbc(std::ostream& output, const std::vector<DbcParameter>& parameters = {});

}  // namespace can_log
