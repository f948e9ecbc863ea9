// The energy of a motion that swings, period by period.
#pragma once
#include <cstddef>
#include <map>
#include <vector>

#include "host_sim/records/record.hpp"

namespace host_sim::data_check {

using Windows = std::vector<double>;
constexpr size_t kHops = 4;  // windows that begin within a period

// The channel of each DOF that is nearest to its rate.
std::map<int, const Channel*> rate_channels(const Record& record);

// Mean squares over one period each, every quarter of a period (`hop` samples), of all DOFs, each in units of its own mean.
Windows energies(const std::map<int, const Channel*>& channels, size_t hop);

}  // namespace host_sim::data_check
