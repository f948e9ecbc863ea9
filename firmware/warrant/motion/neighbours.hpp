// A difference of two nodes' signals from the samples around it, its own sample left out: quadratic least squares through four
// neighbours on either side. White noise of the sample has no part in it. An acceleration that is the slope of velocities has a
// slope for its instrument.
//
// Formats: codes below 2^27, two of them in 32 bits; sums of 256 codes, times 8/172 or 8/60: codes in Q3, 31 bits; then as
// links/node_difference.hpp.
#pragma once
#include "firmware/links/node_difference.hpp"

namespace firmware {

constexpr int kNeighbours = 4;      // on either side
constexpr int kNeighbourGuard = 3;  // bits below a code

// At the middle: (54, 39, 14, -21) / 172.
inline int32_t between_neighbours_q3(const int32_t* x) {
  const int64_t sum = int64_t{54} * (x[-1] + x[1]) + int64_t{39} * (x[-2] + x[2]) + int64_t{14} * (x[-3] + x[3]) -
                      int64_t{21} * (x[-4] + x[4]);
  return static_cast<int32_t>((sum * 195084) >> 22);  // 8 / 172
}
// Slope of the same fit, per sample: (1, 2, 3, 4) / 60 of the differences.
inline int64_t neighbours_slope_q3(const int32_t* x) {
  const int64_t sum =
      (x[1] - x[-1]) + int64_t{2} * (x[2] - x[-2]) + int64_t{3} * (x[3] - x[-3]) + int64_t{4} * (x[4] - x[-4]);
  return (sum * 559241) >> 22;  // 8 / 60
}

// The eight-point slope that an acceleration is made of, per sample times 840: it shares its samples with every slope of its
// neighbours. (1, 5, 6, 8) / 122 of the differences is the slope whose white noise is orthogonal to that:
// 672 * 1 - 168 * 5 + 32 * 6 - 3 * 8 = 0; among all such slopes its own noise is the least, to 0.3 %.
constexpr int kSlopeShift = 7;  // of the acceleration's code
inline int64_t slope_840(const int32_t* x) {
  return int64_t{672} * (x[1] - x[-1]) - int64_t{168} * (x[2] - x[-2]) + int64_t{32} * (x[3] - x[-3]) -
         int64_t{3} * (x[4] - x[-4]);
}
inline int32_t orthogonal_slope_q3(const int32_t* x) {
  const int64_t sum =
      (x[1] - x[-1]) + int64_t{5} * (x[2] - x[-2]) + int64_t{6} * (x[3] - x[-3]) + int64_t{8} * (x[4] - x[-4]);
  return static_cast<int32_t>((sum * 1804936) >> 22);  // 8 * 840 / (122 * 2^kSlopeShift)
}

// near: of either node, between_neighbours_q3().
inline int32_t smoothed(const NodeDifference& d, int32_t near_a, int32_t near_b) {
  return rounded_to_range(int64_t{near_a} * d.gain_a - int64_t{near_b} * d.gain_b, kNeighbourGuard);
}
inline int32_t slope(const NodeDifference& d, const int32_t* a, int at) {
  return rounded_to_range(neighbours_slope_q3(a + at) * d.gain_a, kNeighbourGuard);
}

}  // namespace firmware
