// Displacement channels that count from a place which is not the rig's position of rest.
//
// A spring pulls towards its rest. Where a channel's zero lies elsewhere, every spring seems to carry a constant force, and an
// unknown stiffness comes out near zero.
#pragma once
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/programs/shared/shared_records.hpp"

namespace host_sim {

struct CountedFromRest {
  std::vector<std::string> notes;  // what to say of each channel that was changed
  // Channels that are counted from their mean though forces drive the rig, and from what they swing about: how far that is from their
  // rest the forces say (balance_rest()).
  std::vector<size_t> held_off, swinging;
};

// Takes out of every displacement or angle the mean over all records where the motion stays on one side of zero: where the mean is
// over twice the root mean square about it. kFreeSwings: where nothing drives the rig also what it swings about, where that is over 2 % of the
// root mean square; record by record where they do not swing about the same place. A decay of a few swings has no such centre: where it stays at its end
// counts, and nothing where that is within what its parts say otherwise. Not the angle of a driven arm with a gravity
// torque: that is G sin(u) of the angle as it is.
enum class CentreOf { kOneSide, kFreeSwings };
CountedFromRest count_from_rest(CentreOf of, const rig_file::RigModel& model, SharedRecords& records);

}  // namespace host_sim
