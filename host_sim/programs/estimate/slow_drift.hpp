// Velocities and accelerations that drift below all that drives the rig, where nothing else tells the displacement.
//
// An integral has the drift divided by its frequency: 2 % of a velocity at a twentieth of the motion's frequency is 40 % of the displacement. A
// board's high-pass is chosen before there is a record and takes a part of it; with the record at hand it is seen where drift ends and
// where the drive begins.
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
// and 0.9 lowest_Hz (white noise does so once in 160000 bins). 0: nowhere, or what is slower makes less of the power of that many
// integrals of it than the motion.
double drift_end_Hz(const std::vector<double>& values, double sample_period_s, double lowest_Hz, int integrations);

// The channel without its cosines of half periods up to end_Hz (a discrete cosine transform's, which no jump between the record's ends
// disturbs).
void take_off_cosines(std::vector<double>& values, double sample_period_s, double end_Hz);

// Takes what is slower than the drift's end off all channels of all records, so that the equations of motion hold among them as before.
// Not where no signal is integrated, nothing drives the rig, the drive reaches down to the record's length, or the drift up to a
// quarter of the drive's lowest frequency. Returns what to say of it; empty: all is as it was.
std::string take_off_drift(const rig_file::RigModel& model, SharedRecords& records);

}  // namespace host_sim
