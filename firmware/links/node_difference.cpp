#include "firmware/links/node_difference.hpp"

namespace firmware {
namespace {

constexpr int kMostCodeBits = 23;  // of a channel

int fewer_bits(const NodeCode& a, const NodeCode& b) {
  if (a.unit.is_zero()) return b.bits;
  return b.unit.is_zero() || a.bits < b.bits ? a.bits : b.bits;
}

}  // namespace

NodeDifference node_difference(const NodeCode& a, const NodeCode& b) {
  NodeDifference d;
  const Scaled full_scale = scale_by_power_of_two(a.unit, a.bits) + scale_by_power_of_two(b.unit, b.bits);
  if (full_scale.is_zero()) return d;
  d.range_exponent = static_cast<int16_t>(log2_floor(full_scale) + 1);
  const int fewer = fewer_bits(a, b);
  d.shift_left = static_cast<uint16_t>(fewer < kMostCodeBits ? kMostCodeBits - fewer : 0);
  const int bits = kDifferenceFraction + kDifferenceGainShift - d.range_exponent - d.shift_left;
  d.gain_a = static_cast<int32_t>(to_fixed(a.unit, bits));
  d.gain_b = static_cast<int32_t>(to_fixed(b.unit, bits));
  d.column_a = static_cast<uint16_t>(a.column);
  d.column_b = static_cast<uint16_t>(b.column);
  return d;
}

}  // namespace firmware
