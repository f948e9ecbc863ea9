// Mains hum that a force's channel alone shows.
#pragma once
#include "answer.hpp"

namespace diagnosis::runs {

// Names it where the force has a line at the mains' frequency, the model follows the motion better without it, and no
// motion channel has a like hum of its own: a hum that really acts, of a shaker's amplifier, moves the rig.
void name_force_hum(const Task& task, const State& fitted, Diagnosis& d);

}  // namespace diagnosis::runs
