// Undamped natural frequencies of the rig, to advise where else to excite: M x'' + K x = 0 by Jacobi rotations of
// M^-1/2 K M^-1/2 (symmetric, at most 16 by 16).
#pragma once
#include "firmware/configuration/configuration.hpp"
#include "firmware/identification/estimate.hpp"

namespace firmware {

// Unknown masses and stiffnesses enter with their estimates. Writes dof_count frequencies in Hz, in no order; returns
// false where a mass is not positive.
bool natural_frequencies_Hz(const CoreConfiguration& configuration, const Estimates& estimates, Scaled* frequencies);

}  // namespace firmware
