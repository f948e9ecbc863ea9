// Noise colours, mains hum, drift and the anti-alias filter.
#pragma once
#include "conditions.hpp"
#include "dice.hpp"
#include "true_rig.hpp"

namespace hidden_rig {

Values draw_noise(Dice& dice, const Condition& condition, size_t count);  // of unit rms
Values draw_drift(Dice& dice, size_t count);                              // of unit rms: a ramp and three slow sines
void low_pass(Values& values, double corner);                             // Butterworth, order four; corner per sample

}  // namespace hidden_rig
