// What of long records the first screen looks at.
#pragma once
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace diagnosis {

// The records as they are, or of records so long that their rows would fill the memory some stretches, evenly spread over each:
// what is missing shows in a part of them, and what the screen names is borne out on all of them afterwards. Stretches spread
// over a record see all of a sweep, all levels of a step programme, the early and the late part of a drift.
std::vector<host_sim::Record> stretches(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& records);

}  // namespace diagnosis
