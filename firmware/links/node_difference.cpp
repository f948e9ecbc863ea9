#include "firmware/links/node_difference.hpp"

namespace firmware {

NodeDifference node_difference(int column_a, const Scaled& unit_a, int column_b, const Scaled& unit_b, int code_bits) {
  NodeDifference d;
  const Scaled sum = unit_a + unit_b;
  if (sum.is_zero()) return d;
  d.range_exponent = log2_floor(sum) + 1 + code_bits;
  const int bits = kDifferenceFraction + kDifferenceGainShift - d.range_exponent;
  d.gain_a = static_cast<int32_t>(to_fixed(unit_a, bits));
  d.gain_b = static_cast<int32_t>(to_fixed(unit_b, bits));
  d.column_a = static_cast<uint16_t>(column_a);
  d.column_b = static_cast<uint16_t>(column_b);
  return d;
}

}  // namespace firmware
