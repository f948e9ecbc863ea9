// A difference of two nodes' signals from the samples around it, its own sample left out: quadratic least squares through four
// neighbours on either side. White noise of the sample has no part in it.
//
// Formats: sums of 256 codes, times 8/172 or 8/60: codes in Q3, 31 bits; then as links/node_difference.hpp.
#pragma once
#include "firmware/links/node_difference.hpp"

namespace firmware {

constexpr int kNeighbours = 4;      // on either side
constexpr int kNeighbourGuard = 3;  // bits below a code

// At the middle: (54, 39, 14, -21) / 172.
inline int32_t between_neighbours_q3(const int32_t* x) {
  const int64_t sum = 54 * (int64_t{x[-1]} + x[1]) + 39 * (int64_t{x[-2]} + x[2]) + 14 * (int64_t{x[-3]} + x[3]) -
                      21 * (int64_t{x[-4]} + x[4]);
  return static_cast<int32_t>((sum * 195084) >> 22);  // 8 / 172
}
// Slope of the same fit, per sample: (1, 2, 3, 4) / 60 of the differences.
inline int64_t neighbours_slope_q3(const int32_t* x) {
  const int64_t sum =
      (int64_t{x[1]} - x[-1]) + 2 * (int64_t{x[2]} - x[-2]) + 3 * (int64_t{x[3]} - x[-3]) + 4 * (int64_t{x[4]} - x[-4]);
  return (sum * 559241) >> 22;  // 8 / 60
}

// near: of either node, between_neighbours_q3().
inline int32_t smoothed(const NodeDifference& d, int32_t near_a, int32_t near_b) {
  return rounded_to_range(int64_t{near_a} * d.gain_a - int64_t{near_b} * d.gain_b, kNeighbourGuard);
}
inline int32_t slope(const NodeDifference& d, const int32_t* a, int at) {
  return rounded_to_range(neighbours_slope_q3(a + at) * d.gain_a, kNeighbourGuard);
}

}  // namespace firmware
