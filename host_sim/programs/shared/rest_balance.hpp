// Where a rig rests that forces hold off its mean.
#pragma once
#include <cstddef>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/programs/shared/shared_records.hpp"

namespace host_sim {

// Displacement channels that are counted from about their rest are off by where the mean force holds them: K d = r, with r the mean of
// what the rig's forces leave of each equation of motion (force_balance.hpp) and K the stiffness between the channels' DOFs. Adds d to the
// channels, the smallest such d where masses float that no spring ties to the ground. False, and nothing is changed: no spring holds them, or
// what it bends every spring by is below 1e-5 of its elongation, root mean square.
//   kDriven      one mean over all records, weighted with a bell over each, so that what is under way at its ends does not count
//   kFreeMotion  record by record, weighted with the square of the DOF's speed besides: what friction holds fast is not at its rest
// rig: every coefficient a number. channels: of each record, displacements.
enum class MeanOf { kDriven, kFreeMotion };
bool balance_rest(MeanOf of, const rig_file::RigModel& rig, const std::vector<size_t>& channels,
                  SharedRecords& records);

}  // namespace host_sim
