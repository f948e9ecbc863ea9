// Where a rig rests that forces hold off its mean.
#pragma once
#include <cstddef>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/programs/shared/shared_records.hpp"

namespace host_sim {

// Displacement channels that are counted from their mean are off by where the mean force holds them: K d = r, with r the mean of what
// the rig's forces leave of each equation of motion (force_balance.hpp; weighted with a bell over each record, so that
// what is under way at its ends does not count) and K the stiffness between the channels' DOFs. Adds d to the channels. False, and
// nothing is changed: no spring holds them, or what they are off by is below a thousandth of their root mean square.
// rig: every coefficient a number. channels: of each record, displacements.
bool balance_rest(const rig_file::RigModel& rig, const std::vector<size_t>& channels, SharedRecords& records);

}  // namespace host_sim
