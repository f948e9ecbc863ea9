// Forces that are written at their changes, as a drive's command is: in few rows of their own, beside the many of the motion.
#pragma once
#include <string>
#include <vector>

#include "host_sim/records/record.hpp"

namespace host_sim {

// Of the forces that have no value (NaN) in most rows, those that are commands: their values lie at least ten times as far apart
// as those of the channel that has most, and are no smooth curve; or a hundred times as far, where no measurement of the
// force could tell what drives such a motion. Each is held from one value to the next, and the last to the end (before the first it
// stays NaN), and marked so. time_s: of the rows, s, increasing. Returns a note for each.
std::vector<std::string> hold_commands(const std::vector<double>& time_s, std::vector<Channel>& channels);

}  // namespace host_sim
