// Delays between the channels of a DOF that the records show well enough to take them out.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/programs/results/estimate_result.hpp"

namespace host_sim {

struct DelayCorrection {
  std::string channel;
  double late_us = 0.0, std_us = 0.0;  // positive: late
};

// One channel per DOF: where displacement and acceleration are late against the velocity alike, the velocity is early. Only
// delays of over eight standard deviations and at most three sample periods (the reach of the core's filter).
std::vector<DelayCorrection> delays_to_correct(const std::vector<SkewResult>& skews, double sample_period_s);

// The rig whose file says these delays, on top of those that it says already.
rig_file::RigModel with_delays(const rig_file::RigModel& model, const std::vector<DelayCorrection>& corrections);

// "displacement_1_m was 399 us late (+- 2): corrected"
std::string correction_note(const DelayCorrection& correction);

}  // namespace host_sim
