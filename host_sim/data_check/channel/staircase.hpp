// A motion channel whose sensor tells something new less often than the rows come.
#pragma once
#include <optional>

#include "host_sim/data_check/data_check.hpp"
#include "host_sim/data_check/measures/statistics.hpp"

namespace host_sim::data_check {

// staircase: each value is held over several rows (host_sim/records/steps/updates.hpp). A doubt where what is missed meanwhile is over
// 1 % of the channel's rms. Of a force nothing is said: a command is held.
std::optional<Finding> find_staircase(const Record& record, const Channel& channel, const Statistics& statistics);

}  // namespace host_sim::data_check
