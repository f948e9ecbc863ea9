// Channels that drift below all that drives the rig.
//
// An integral has the drift divided by its frequency: 2 % of a velocity at a twentieth of the motion's frequency is 40 % of the displacement. A
// board's high-pass is chosen before there is a record and takes a part of it; with the record at hand it is seen where drift ends and
// where the drive begins. A displacement that drifts itself, as an optical sensor that warms up does, has the springs pull with it.
#pragma once
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

struct Drift {
  double end_Hz = 0.0;  // 0: nothing drifts that matters
  double lowest_drive_Hz = 0.0;
  std::string channel;  // the first that does
};
enum class DriftOf { kDisplacements, kIntegrated };

// Of displacements a tenth of their rms matters, of what is integrated as much as the displacement itself. Nothing where nothing drives
// the rig, the drive reaches down to the record's length, the drift up to a third of the drive's lowest frequency, or no spring holds
// the rig. A displacement may be as slow as that by itself, where a force of place is uneven: whether it drifts shows when it is taken off.
Drift drift_of(DriftOf which, const rig_file::RigModel& model, const std::vector<Record>& records);
// Off all channels of all records, so that the equations of motion hold among them as before; of displacements with their means, as the zero
// of what drifts is nowhere.
void take_off(DriftOf which, const Drift& drift, std::vector<Record>& records);
std::string said_of(const Drift& drift);

}  // namespace host_sim
