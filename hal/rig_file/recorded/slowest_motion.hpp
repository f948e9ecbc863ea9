// How far down the spectrum a recorded motion reaches: how high the corner of a high-pass may lie above nothing that moves.
//
// All signals of an equation pass the same high-pass, so it bends no linear force, wherever its corner is. Friction's sign is that of
// the whole rate: what the filter takes away of the rate's power makes the sign wrong around reversals.
#pragma once
#include <vector>

#include "firmware/acquisition/raw_sample.hpp"
#include "firmware/configuration/configuration.hpp"
#include "hal/rig_file/recorded/channel_noise.hpp"

namespace rig_file {

// Number p of octaves below the sample rate, so that no node's velocity, in no record, has more than 1 % of its power below
// rate / 2^p: sure noise apart, which would be taken for slow motion where an acceleration is integrated. Each record counts as far
// down as four periods fit into it. `most`: the largest number of interest, which is the answer where nothing moves.
int octaves_to_slowest_motion(const firmware::CoreConfiguration& configuration,
                              const std::vector<std::vector<firmware::RawSample>>& records, const NodeNoise& noise,
                              int most);

}  // namespace rig_file
