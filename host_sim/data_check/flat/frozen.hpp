// A channel that stands still for a part of its record while the others go on.
#pragma once
#include <vector>

#include "host_sim/data_check/data_check.hpp"
#include "host_sim/data_check/measures/statistics.hpp"

namespace host_sim::data_check {

// dead: a channel, noisy over two steps of its resolution, that holds one value for longer than its noise lets equal values meet by chance
// (one record in a million), while every other channel that changes at all goes on as lively. A sensor at rest still shows its noise, and a rig that comes to rest takes
// all its channels along. A fault from a hundredth of the record on, else a doubt.
std::vector<Finding> find_frozen(const Record& record, const std::vector<Statistics>& statistics);

}  // namespace host_sim::data_check
