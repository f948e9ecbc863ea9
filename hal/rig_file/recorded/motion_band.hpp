// How far up the spectrum a recorded displacement or velocity moves: whether a low-pass to a tenth of the sample rate takes rate away.
//
// All signals of an equation pass the same low-pass, so it bends no linear force. Friction's sign is that of the whole rate: where a
// share s of its power is taken away the sign is wrong around every reversal, and friction comes out s / 2 too small.
#pragma once
#include <vector>

#include "firmware/acquisition/raw_sample.hpp"
#include "hal/rig_file/recorded/channel_noise.hpp"

namespace rig_file {

// noise: of this quantity of `node`. True where more than 1 % of the power of its rate (a displacement's slope), beyond what
// noise has there, lies above the pass band of Band::kTenth (filter_design.hpp).
bool moves_beyond_a_tenth(const std::vector<std::vector<firmware::RawSample>>& records, int node, int quantity,
                          const ChannelNoise& noise);

}  // namespace rig_file
