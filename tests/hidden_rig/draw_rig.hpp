// Masses, links and hidden effects from dice.
#pragma once
#include "conditions.hpp"
#include "dice.hpp"
#include "draw.hpp"
#include "integrator.hpp"

namespace hidden_rig {

TrueRig draw_rig(Dice& dice, const Condition& condition, int masses);  // 0 masses: as the condition says
// Dry friction on some links, in proportion to their damping force without it.
void draw_friction(Dice& dice, const Condition& condition, TrueRig& rig, const Motion& motion);

// Adds an effect of this kind, its shape and a first coefficient from the motion without it. Empty, or why the rig cannot
// carry it.
std::string hide(Dice& dice, const std::string& kind, const Settings& settings, const Condition& condition,
                 TrueRig& rig, const Motion& motion, const Drive& drive);
bool is_measurement_fault(const std::string& kind);
bool linear_in_strength(const std::string& kind);
// rms(hidden force) / rms(damping force of its link, or of the DOF's links).
double rho_of(const TrueRig& rig, const Motion& motion, size_t effect);

}  // namespace hidden_rig
