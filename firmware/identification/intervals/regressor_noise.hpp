// Noise in the columns of the rows. It makes a least-squares fit too small: a row that knows nothing but noisy columns is
// satisfied best where all its parameters are zero (masses, springs and dampers of DOFs that no force drives).
//
// With errors E in the whitened columns X the fit is shifted by -(X'X)^-1 V p, V the sum over rows of mean(E' E) and p the true
// parameters: the fit less its shift. Where the columns are mostly noise the shift is most of p, many times what V makes of the fit;
// so it is found turn by turn. The residual of a row is its errors' sum; they are taken to be independent, each in proportion to the
// energy of its term, so that mean(E' E)_kk = residual^2 share_k / p_k^2: the same of a fit that is too small as a whole. Terms that
// share a channel err together, which the model does not know: so the shift is taken out, and as much again is a deviation in the
// interval. Only where masses or springs are unknown: rows that hold a known force or a known spring are not satisfied by zero.
#pragma once
#include "firmware/identification/estimate.hpp"
#include "firmware/identification/fit/weighted_fit.hpp"

namespace firmware {

// Corrects values, widens standard deviations and intervals. Returns the parameters that noise may have taken to any part of
// themselves, a bit for each. Of cores with three weights or more.
uint64_t take_out_regressor_noise(const EquationList& list, const BatchTable& table, WeightedFit& fit,
                                  Estimates& estimates);

}  // namespace firmware
