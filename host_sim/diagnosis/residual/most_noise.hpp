// How much of what is left noise may be.
#pragma once
#include "left.hpp"

namespace diagnosis::runs {

// What a model leaves, in the band of the motion over beside it: 0.95 to 1.05 on complete drawn rigs in white noise. Coloured
// noise has more (AR(0.8) 30 to 40 where the motion is slow for the sampling rate): whether it is noise says the motion, which noise
// does not know.
constexpr double kSurelyNoise =
    1.3;  // nothing is asked up to here: bands of a hundred lines scatter by that, three deviations
constexpr double kBeyondNoise = 3;  // where there are too few windows to ask

// Mean square of what values in steps miss of the motion. Where it moves slowly over them that is no white noise: it may lie
// in the band of the motion altogether.
double of_steps(const std::vector<Prepared>& records, size_t channel);

// Mean square per channel that noise may have, of any colour: what the sensors show where the rig is at rest after it has moved,
// and their steps. Huge where no record rests for a period, and of accelerations: friction makes them jump, and when it does is known
// to a sample at best.
Vec most_noise(const std::vector<Prepared>& records);

}  // namespace diagnosis::runs
