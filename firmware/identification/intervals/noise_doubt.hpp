// What a doubtful noise of derived signals may do to the parameters.
//
// The mean product of the noise that a filter puts into a row's weight and into its forces is taken out of the energies
// (CoreConfiguration::shared_noise). It is the same in every batch, so no scatter shows an error in it. Where the noise is known
// to a share only (motion_noise_doubt), that share of its whole effect on a parameter is part of the parameter's interval.
#pragma once
#include "firmware/identification/estimate.hpp"
#include "firmware/identification/fit/weighted_fit.hpp"

namespace firmware {

// Widens standard deviations and intervals.
void add_noise_doubt(const CoreConfiguration& configuration, const EquationList& list, const BatchTable& table,
                     WeightedFit& fit, Estimates& estimates);

}  // namespace firmware
