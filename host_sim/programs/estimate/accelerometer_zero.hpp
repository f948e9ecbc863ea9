// Accelerometers that read something at rest: a part of gravity, an amplifier's offset.
//
// An acceleration enters the equations of motion with its zero: one of a hundredth of a metre a second squared passes for a constant
// force. A velocity or displacement of the same place tells it apart.
#pragma once
#include <string>
#include <vector>

#include "host_sim/programs/shared/shared_records.hpp"

namespace host_sim {

// Takes the zero off every acceleration that has a velocity or displacement of its DOF (or of the base) beside it, each record its
// own, where it is beyond what the scatter over the record makes. Returns what to say of each channel, of its largest.
std::vector<std::string> take_off_accelerometer_zeros(SharedRecords& records);

}  // namespace host_sim
