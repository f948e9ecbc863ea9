// The paper's plain product against the instrument: noise in the regressors shifts the first, not the second (white
// noise). The difference is one step of the fit with plain rows in place of the instrumented ones, same weights; its
// own scatter comes from the batches.
#pragma once
#include "firmware/identification/estimate.hpp"
#include "firmware/identification/fit/weighted_fit.hpp"

namespace firmware {

struct BiasCheck {
  Scaled difference[kMaxUnknowns];  // plain minus instrumented estimate
  Scaled deviation[kMaxUnknowns];   // its standard deviation; until the end its square
  // Working memory: what the rows of one batch give to the normal equations.
  PackedScaled moment[kMaxBatches][kMaxUnknowns];
};

// All stays zero where the table holds no instrument: there is nothing to compare.
void begin_comparison(BiasCheck& result);
// Adds the level l that the fit has loaded, whose residuals are lost.
void compare_with_plain(const EquationList& list, LevelColumns& level, int l, WeightedFit& fit, BiasCheck& result);
void end_comparison(const EquationList& list, BiasCheck& result);

// A shift over three deviations, over the half width of the interval and over 5 % of the value: so much noise in this
// parameter that its value rests on the instrument's assumption, noise independent from sample to sample.
bool bias_suspect(const BiasCheck& check, int unknown, const ParameterEstimate& parameter);

}  // namespace firmware
