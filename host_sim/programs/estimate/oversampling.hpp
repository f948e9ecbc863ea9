// Records whose motion ends far below their sample rate, where derivatives would carry the noise of all that lies above it.
//
// A displacement that is differentiated twice passes a low-pass to a tenth of the sample rate (hal/rig_file/filter_design.hpp), and the
// acceleration's noise grows with the corner to the power of 5/2. A board's rate is chosen before there is a record; with the
// record at hand it is seen where its motion ends.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/programs/shared/shared_records.hpp"

namespace host_sim {

struct Oversampling {
  size_t factor = 1;       // every so many samples one is enough
  double motion_Hz = 0.0;  // no channel of motion rises above its noise beyond this
};

// Factor 1 where no signal of the rig's equations is made by differences, a sensor reaches its end, the shortest record would be left
// with fewer samples than eight stretches of the score tests take, or the filters would take longer to
// begin than the bulk of a motion lasts.
Oversampling oversampling_of(const rig_file::RigModel& model, const std::vector<Record>& records);

// The highest frequency at which the channel's power, a mean over three bins, is over four times its noise: the median of the
// top quarter of its spectrum, which is flat there. Twenty degrees of freedom of white noise are so once in 10^8 bins.
double highest_motion_Hz(const std::vector<double>& values, double sample_period_s);

// Replaces the samples by as many as their motion needs (records/thin_out.hpp) and leaves the units of converters' codes in the rig file
// to the data: what is behind the low-pass lies between two codes. Returns what to say of it; empty: all is as it was.
std::string take_fewer_samples(rig_file::RigModel& model, SharedRecords& records);

}  // namespace host_sim
