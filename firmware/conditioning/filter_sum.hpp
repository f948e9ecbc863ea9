// The weighted sums of a signal's filter. Exact, so the order of the steps does not show.
//
// Taps that are even or odd about the middle one (filters of a displacement, of its slopes) weigh the sum or the difference of two
// samples that stand opposite to each other: half the multiplications.
//
// Formats: taps 30 bits times codes of 24 bits, or of 25 bits times 31; at most 57 of them: below 2^62. A sum of two codes has one
// bit more: only for codes of 24 to 30 bits.
#pragma once
#include "firmware/acquisition/columns.hpp"

namespace firmware {

using Tap = Fixed<int32_t, 0>;
constexpr int32_t kSignalLimit = 1 << 23;

// tap: 2 * half_length + 1 of them, oldest first. 1 even, -1 odd, 0 neither.
int parity_of(const Tap* tap, int half_length);
// All taps one by one. middle: the sample that the middle tap weighs; half_length of them on either side, older ones before it.
int64_t filter_sum(const Tap* tap, const Code* middle, int half_length);

// sum / 2^shift to nearest, |sum| < 2^62; just beyond kSignalLimit, or more, where it is beyond.
Code nearest(int64_t sum, int shift);
// That of a signal's filter. Odd: the middle tap is 0.
Code even_signal(const SignalConfiguration& signal, const Code* middle);
Code odd_signal(const SignalConfiguration& signal, const Code* middle);
Code filter_signal(const SignalConfiguration& signal, const Code* middle, int parity);

}  // namespace firmware
