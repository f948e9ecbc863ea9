// Displacement and acceleration of a DOF whose velocity is not measured: they tell that one of them is late or has another gain, and
// not which.
#pragma once
#include <vector>

#include "host_sim/programs/estimate/channel_correction.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// Is the DOF's velocity measured?
bool measures_velocity(const std::vector<Record>& records, int dof);

// The corrections that would each make the two agree, of the DOF where they disagree most clearly; by_channels is false, for the
// equations of motion have to choose. Empty: they agree everywhere, within eight deviations.
std::vector<ChannelCorrection> pair_corrections(const std::vector<Record>& records);

}  // namespace host_sim
