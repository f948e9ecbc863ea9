// The sensors of a blind draw: faults, noise, quantisation; and what a seed asks for.
#pragma once
#include <vector>

#include "draw.hpp"
#include "tests/hidden_rig/dice.hpp"

namespace hidden {

using hidden_rig::Dice;

using Values = std::vector<double>;
constexpr double kPeriod = 1e-3;  // of every record, s

double rms(const Values& values);

// The draw's record: force, motion as the settings' sensors see it, with faults (written down as truth), noise and steps.
void measure(Dice& dice, Draw& draw, const Motion& motion, const Values& force, const Settings& settings);

}  // namespace hidden
