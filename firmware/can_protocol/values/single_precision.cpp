#include "firmware/can_protocol/values/single_precision.hpp"

namespace firmware {
namespace {

constexpr int kFractionBits = 23;
constexpr int32_t kLowestExponent = -126;  // of a normal number
constexpr int32_t kHighestExponent = 127;
constexpr uint32_t kInfinityBits = 0x7F800000;

// value / 2^drop to the nearest integer, halves to the even one; 1 <= drop.
uint64_t rounded(uint64_t value, int32_t drop) {
  if (drop > 63) return 0;  // value < 2^62
  const uint64_t kept = value >> drop, rest = value & ((uint64_t{1} << drop) - 1), half = uint64_t{1} << (drop - 1);
  const bool up = rest > half || (rest == half && (kept & 1u) != 0);
  return kept + (up ? 1 : 0);
}

}  // namespace

uint32_t single_precision_bits(Scaled value) {
  if (value.is_zero()) return 0;
  const uint32_t sign = value.is_negative() ? 0x80000000u : 0u;
  const int32_t exponent = log2_floor(value);
  if (exponent > kHighestExponent) return sign | kInfinityBits;
  // The last place that the result has: 2^(exponent - 23), and no finer than 2^-149.
  const int32_t last_place = (exponent < kLowestExponent ? kLowestExponent : exponent) - kFractionBits;
  const auto magnitude = static_cast<uint64_t>(value.is_negative() ? -value.mantissa : value.mantissa);
  const uint64_t places = rounded(magnitude, last_place - value.exponent);
  if (exponent < kLowestExponent) return sign | static_cast<uint32_t>(places);  // a carry to 2^23 is the first normal
  // The leading bit of `places` adds 1 to the exponent field; a carry to 2^24 adds another, with no fraction left.
  const auto field = static_cast<uint32_t>(exponent - kLowestExponent) << kFractionBits;
  return sign | (field + static_cast<uint32_t>(places));
}

}  // namespace firmware
