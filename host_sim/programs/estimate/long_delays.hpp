// Delays that reach over more samples than the core's filters do.
#pragma once
#include <string>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/programs/shared/shared_records.hpp"

namespace host_sim {

// Where the rig file states a delay of over three sample periods (hal/rig_file/signals/taps.cpp takes no longer one): every channel is read
// by its whole samples later or earlier, the records lose what none has then at their ends, and the rig file keeps what is left of
// each delay, half a sample at most. Returns what to say of it; empty: all is as it was. Throws std::runtime_error where a record is
// shorter than its delays.
std::string take_out_long_delays(rig_file::RigModel& model, SharedRecords& records);

}  // namespace host_sim
