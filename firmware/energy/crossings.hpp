// The sign change of a rate inside a sample interval. A trapezoid over q sgn(w) takes the sign to change half way; with the
// crossing at the fraction theta of the interval, s0 the sign before it and q0, q1 the weight at its ends, the integral gains
//   h s0 [ (2 theta - 1) q0 + (theta^2 - 1/6) (q1 - q0) ]
// (exact integral of the linear q minus the trapezoid, and Gregory's end corrections on either side of the jump).
// Used where the acceleration is not measured. Where it is, the sums of sampled equations of motion are exact without it.
//
// Formats: theta Q16; weight 27 bits; one correction below 2^46, 1024 of them below 2^56.
#pragma once
#include "firmware/links/link_motion.hpp"

namespace firmware {

using Crossing = Fixed<int64_t, 16>;  // of the weight's code

// For one interval whose rate goes from w0 to w1 with opposite signs.
Crossing crossing_correction(Rate w0, Rate w1, Code q0, Code q1);
// The sum over all sign changes in the intervals [n, n + 1], from <= n < to.
Crossing crossing_corrections(const Rate* rate, ConstColumn<Code> weight, int from, int to);

}  // namespace firmware
