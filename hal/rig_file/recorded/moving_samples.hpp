// For how long a recorded motion lasts.
#pragma once
#include "hal/rig_file/recorded/channel_codes.hpp"

namespace rig_file {

// (sum of y^2)^2 / sum of y^4 of a channel about its mean, of the record where it is least: of a band of noise a third of all samples, of a
// sine two thirds, of a decay exp(-t / tau) of some turns 2/3 tau. 0: nothing moves.
double fewest_moving_samples(const ChannelCodes& records);

}  // namespace rig_file
