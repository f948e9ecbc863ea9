// How far apart the levels of several records are.
#pragma once
#include <vector>

#include "host_sim/records/record.hpp"

namespace host_sim {

// The rms of what drives a record (its forces, else its base, else its motion), largest over smallest; 1 for one record.
double level_ratio(const std::vector<Record>& records);

}  // namespace host_sim
