// Standard deviation and 95 % interval of every parameter from the measured scatter.
#pragma once
#include "firmware/identification/estimate.hpp"
#include "firmware/identification/weighted_fit.hpp"

namespace firmware {

// Variance of p_k = sum over equations of (share of the equation in the covariance) * inflation; degrees of freedom
// after Welch and Satterthwaite. Where no scatter could be measured the residuals of the fit give the scale. Fills
// value, std, interval, rows, residual_mean_abs.
void estimate_uncertainty(const EquationList& list, const BatchTable& table, WeightedFit& fit, Estimates& estimates);

}  // namespace firmware
