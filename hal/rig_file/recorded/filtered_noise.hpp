// Noise that an anti-alias filter has passed: level up to the filter's corner, next to nothing above it.
//
// Read from the spectrum of a displacement, whose motion falls off well below the corner: where two neighbouring bands of a third of an
// octave are alike the motion has ended. That level is continued downwards, the spectrum above it is the filter's own shape.
#pragma once
#include <vector>

#include "hal/rig_file/recorded/channel_codes.hpp"

namespace rig_file {

struct FilteredNoise {
  double variance = 0;              // codes^2; 0: the spectrum has no such shape
  double doubt = 0;                 // of the variance, a share
  std::vector<double> correlation;  // over lags from 0, of variance 1
};

FilteredNoise read_filtered_noise(const ChannelCodes& records);

}  // namespace rig_file
