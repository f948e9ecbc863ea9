// Channels that drift below all that drives the rig.
//
// An integral has the drift divided by its frequency: 2 % of a velocity at a twentieth of the motion's frequency is 40 % of the displacement. A
// board's high-pass is chosen before there is a record and takes a part of it; with the record at hand it is seen where drift ends and
// where the drive begins. A displacement that drifts itself, as an optical sensor that warms up does, has the springs pull with it.
#pragma once
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/programs/shared/shared_records.hpp"

namespace host_sim {

// The lowest frequency of the band that drives, of a force or of a channel of the base. Down to it the power, a mean over nine bins, is over
// four times the noise (the median of the top quarter of the spectrum), and no more than 1 % of it lies below a gap. 0 where the band reaches down
// to the record's length.
double lowest_drive_Hz(const std::vector<double>& values, double sample_period_s);

// The highest frequency below lowest_Hz / 2 at which the channel stands out of its noise there, by twelve times the level between lowest_Hz / 2
// and 0.9 lowest_Hz (white noise does so once in 160000 bins). 0: nowhere, or what is slower makes less than that share of
// the motion's power in as many integrals of it.
double drift_end_Hz(const std::vector<double>& values, double sample_period_s, double lowest_Hz, int integrations,
                    double least_share);

// The channel without its cosines of half periods up to end_Hz (a discrete cosine transform's, which no jump between the record's ends
// disturbs).
void take_off_cosines(std::vector<double>& values, double sample_period_s, double end_Hz);

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
