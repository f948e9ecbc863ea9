// Channels that never change, or stop changing while the motion goes on.
#pragma once
#include <vector>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// For the record's channels in their order. A constant force is no force (one that is held as a command is a constant
// force), a constant base stands still: both are said and nothing more, unless the motion grows again by a factor of 10 without any force or base that moves: a passive rig
// cannot. A constant motion is a fault where another channel of the DOF moves, or where it is all that the DOF has and
// the rest of the rig moves in no record of it. A channel that stops for good within the record, from one fortieth of it
// to the next, while all others go on, is a fault as well; one that shows nothing but white noise then goes on with
// nothing. moves_elsewhere: the channel changes in another record.
std::vector<std::optional<Finding>> find_dead(const Record& record, const std::vector<bool>& moves_elsewhere);

}  // namespace host_sim::data_check
