// The same quantity of two nodes as one number: u = x_a - x_b, or of one node alone.
//
// Formats: code 24 bits (a derived one up to 27) times gain of at most 2^28, two of them below 2^57; shifted by 25: Q26 of a
// range 2^range_exponent that holds both codes' full scale, |.| <= 2^26. Where full scale has fewer bits (a 16-bit converter) the range is
// its, and what the gain has no room for is shifted in behind: code of full scale times gain, shifted, is at most 2^51 of either, and
// what saturates (23 bits) below 2^61, two of them below 2^62.
#pragma once
#include <cstdint>

#include "firmware/fixed_point/in_place.hpp"
#include "firmware/fixed_point/magnitude.hpp"
#include "firmware/fixed_point/scaled.hpp"

namespace firmware {

constexpr int kDifferenceFraction = 26;
constexpr int kDifferenceGainShift = 25;

struct NodeDifference {
  uint16_t column_a = 0, column_b = 0;
  int32_t gain_a = 0, gain_b = 0;  // 0: not there
  int16_t range_exponent = 0;
  uint16_t shift_left = 0;  // of codes times gains, before they come to the range
  bool present() const { return gain_a != 0 || gain_b != 0; }
};

struct NodeCode {
  int column = 0;
  Scaled unit;    // SI units of a code; zero where the node is the ground or has no such signal
  int bits = 23;  // of full scale, without sign; at least kLeastCodeBits
};
constexpr int kLeastCodeBits = 13;
NodeDifference node_difference(const NodeCode& a, const NodeCode& b);

// value = codes times gains in 2^-(kDifferenceGainShift + guard); to Q26.
FIRMWARE_ONCE int32_t rounded_to_range(int64_t value, int guard) {
  const int shift = kDifferenceGainShift + guard;
  return static_cast<int32_t>(
      limited((value + (int64_t{1} << (shift - 1))) >> shift, int64_t{1} << kDifferenceFraction));
}
inline int32_t difference_at(const NodeDifference& d, const int32_t* a, const int32_t* b, int at) {
  return rounded_to_range((int64_t{a[at]} * d.gain_a - int64_t{b[at]} * d.gain_b) * (int64_t{1} << d.shift_left), 0);
}

}  // namespace firmware
