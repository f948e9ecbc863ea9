// Mains hum that a force's channel alone shows.
#pragma once
#include "../choice/choice.hpp"
#include "../diagnosis.hpp"

namespace diagnosis::runs {

// Names it where the force has a line at the mains' frequency, the model follows the motion better without it, and no
// motion channel has a like hum of its own: a hum that really acts, of a shaker's amplifier, moves the rig.
void name_force_hum(const Task& task, const State& fitted, Diagnosis& d);

// Amplitude of the wave of a reading at a mains' frequency, 50 or 60 Hz: a hum, or what drives the rig there. 0 of no reading.
double wave_at_mains(const Vec& reading, double step_s, double nominal_Hz);

}  // namespace diagnosis::runs
