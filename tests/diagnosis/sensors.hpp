// The sensors of a blind draw: faults, noise, quantisation; and what a seed asks for.
#pragma once
#include <vector>

#include "dice.hpp"
#include "draw.hpp"

namespace hidden {

using Values = std::vector<double>;
constexpr double kPeriod = 1e-3;  // of every record, s

double rms(const Values& values);

// The draw's record: force, motion as the settings' sensors see it, with faults (written down as truth), noise and steps.
void measure(Dice& dice, Draw& draw, const Motion& motion, const Values& force, const Settings& settings);

}  // namespace hidden
