// Derived signals that are made of too few codes.
//
// An integral or a slope has the full scale that its plan gave it, before anybody knew the motion (SignalConfiguration). One that stays
// far below it is mostly rounding: a sine of the amplitude A, in codes, comes out wrong by up to 0.2 A^-1.5 of itself, and the spring
// or mass in proportion to that; below half a code nothing of it is left.
#pragma once
#include "firmware/energy/batch_table.hpp"

namespace firmware {

// Whether a derived signal of a DOF in whose equation the unknown stands has less than 16 codes rms in every level: then it may be 0.2 % off
// or more. As far as the table keeps the signal's square: a displacement's where a mass, a spring or the like is unknown.
bool has_few_codes(const BatchTable& table, const CoreConfiguration& configuration, int unknown);

}  // namespace firmware
