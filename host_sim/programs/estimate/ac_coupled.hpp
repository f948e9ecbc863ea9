// Accelerometers behind a high-pass that the other channels of their DOF show.
#pragma once
#include <string>
#include <vector>

#include "host_sim/programs/shared/shared_records.hpp"

namespace host_sim {

// Undoes what half of the records or more show of one channel (data_check/one_motion/coupling.hpp), with the mean of their corners. A lead that falls
// with the frequency is no delay: taken out as one it bends every damper. One sentence for each channel.
std::vector<std::string> undo_shown_ac_couplings(SharedRecords& records);

}  // namespace host_sim
