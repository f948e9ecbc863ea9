// Equations that leave their scale open.
//
// A DOF on which no force is measured and of whose coefficients none is known has an equation that any multiple of a solution
// solves, nought first of all: noise in its columns draws it there, as certain as it is wrong. Its links' forces set the scale,
// in the equations of the DOFs at their other ends. Where its mass is not determined all the same, what the links were taken to
// carry bends those.
#pragma once
#include "firmware/configuration/configuration.hpp"
#include "firmware/identification/estimate.hpp"
#include "firmware/identification/rows/rows.hpp"

namespace firmware {

// BIAS_SUSPECT in place of VALID for every coefficient that acts on a DOF of such a scale or on one that a link joins to it.
void doubt_beside_open_scale(const CoreConfiguration& configuration, const EquationList& list, Estimates& estimates);

}  // namespace firmware
