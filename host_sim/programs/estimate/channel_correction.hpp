// Delays and gains of channels that the records show well enough to take them out.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/programs/results/estimate_result.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

struct ChannelCorrection {
  std::string channel;
  double late_us = 0.0;  // positive: late
  double gain = 0.0;     // it says 1 + gain times the truth
  double std = 0.0;      // of the delay in us, or of the gain
  // From what channels say of each other, no matter what the rig is; else it is what explains the equations' residual best.
  bool by_channels = true;
};

// Delays between the channels of a DOF whose velocity is measured, one channel per DOF: where displacement and acceleration are late against the velocity
// alike, the velocity is early. Only delays of over eight standard deviations and at most three sample periods (the reach of
// the core's filter).
std::vector<ChannelCorrection> delays_to_correct(const std::vector<SkewResult>& skews,
                                                 const std::vector<Record>& records);

// The delays; where there are none the gain, or the force's delay, that the board names, if it is as well measured, small enough to be a
// calibration (a fifth; more is a slip for a person to look at), and no other cause can stand in its place: what the rival
// would leave of the named force is over 5.5 deviations.
// first: nothing has been corrected yet. After that the equations of motion are no witness: what they show may be what the
// correction leaves.
std::vector<ChannelCorrection> corrections_to_make(const EstimateResult& result, const std::vector<Record>& records,
                                                   bool first);

// What is left of a correction adds to it: a delay of a whole sample is read a fortieth too small, because sin(w tau) is below w tau.
void add_corrections(const std::vector<ChannelCorrection>& more, std::vector<ChannelCorrection>& corrections);

// The rig whose file says these delays, on top of those that it says already.
rig_file::RigModel with_delays(const rig_file::RigModel& model, const std::vector<ChannelCorrection>& corrections);
bool any_gain(const std::vector<ChannelCorrection>& corrections);
std::vector<Record> without_gains(const std::vector<ChannelCorrection>& corrections,
                                  const std::vector<Record>& records);

// The corrected records say what they should: nothing is left to correct, and where the equations were what showed it, nothing
// is suspected.
bool corrections_hold(const EstimateResult& corrected, const std::vector<ChannelCorrection>& corrections,
                      const std::vector<Record>& records);

// Says in the corrected result what has been corrected. The gain of the only force of a rig is known by its masses and springs alone: were
// the force right, they and every coefficient would be 1 + gain times as large, so the intervals hold that too.
void tell_corrections(const std::vector<ChannelCorrection>& corrections, const std::vector<Record>& records,
                      EstimateResult& corrected);
// "displacement_1_m was 399 us late (+- 2): corrected"
std::string correction_note(const ChannelCorrection& correction);

}  // namespace host_sim
