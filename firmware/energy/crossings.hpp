// The sign change of a rate inside a sample interval. A trapezoid over q sgn(w) takes the sign to change half way; with the
// crossing at the fraction theta of the interval, s0 the sign before it and q0, q1 the weight at its ends, the integral gains
//   h s0 [ (2 theta - 1) q0 + (theta^2 - 1/6) (q1 - q0) ]
// (exact integral of the linear q minus the trapezoid, and Gregory's end corrections on either side of the jump).
// Used where the acceleration is not measured. Where it is, the sums of sampled equations of motion are exact without it.
//
// Formats: theta Q16; weight 27 bits; one correction below 2^46, 1024 of them below 2^56.
#pragma once
#include "firmware/acquisition/columns.hpp"

namespace firmware {

// Correction in Q16 of the weight's code, for one interval whose rate goes from w0 to w1 with opposite signs.
int64_t crossing_correction_q16(int64_t w0, int64_t w1, int32_t q0, int32_t q1);
// The sum over all sign changes in the intervals [n, n + 1], from <= n < to.
int64_t crossing_corrections_q16(const int64_t* rate, const int32_t* weight, int from, int to);

}  // namespace firmware
