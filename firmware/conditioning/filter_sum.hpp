// The weighted sums of a signal's filter. Exact, so the order of the steps does not show.
//
// Taps that are even or odd about the middle one (filters of a displacement, of its slopes) weigh the sum or the difference of two
// samples that stand opposite to each other: half the multiplications, and for two filters of one length half the samples read.
//
// Formats: taps 30 bits times codes of 24 bits, or of 25 bits times 31; at most 57 of them: below 2^62. A sum of two codes has one
// bit more: only for codes of 24 to 30 bits.
#pragma once
#include "firmware/acquisition/columns.hpp"

namespace firmware {

using Tap = Fixed<int32_t, 0>;

// tap: 2 * half_length + 1 of them, oldest first. 1 even, -1 odd, 0 neither.
int parity_of(const Tap* tap, int half_length);
// middle: the sample that the middle tap weighs; half_length of them on either side, older ones before it.
int64_t filter_sum(int parity, const Tap* tap, const Code* middle, int half_length);

struct OddAndEven {
  int64_t odd, even;
};
// Two filters of one length at once, the first of odd and the second of even taps.
OddAndEven odd_and_even_sum(const Tap* odd_tap, const Tap* even_tap, const Code* middle, int half_length);

struct ThreeSums {
  int64_t displacement, velocity, acceleration;
};
// Three filters at once, in the order of the quantities: the first and the third of even taps, the second of odd ones; the
// last two of one length, the first at most as long.
ThreeSums three_sums(const SignalConfiguration* signal, const Code* middle);

}  // namespace firmware
