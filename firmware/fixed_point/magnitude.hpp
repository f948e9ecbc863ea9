// Size and limit of whole numbers; of typed ones fixed.hpp has size_of() and limited().
#pragma once
#include <cstdint>

namespace firmware {

// |value| without overflow, also of the most negative number.
constexpr uint64_t magnitude(int64_t value) {
  return value < 0 ? ~static_cast<uint64_t>(value) + 1 : static_cast<uint64_t>(value);
}
// |value|, for what is not the most negative number.
constexpr int64_t size_of(int64_t value) { return value < 0 ? -value : value; }
constexpr int64_t limited(int64_t value, int64_t limit) {
  return value > limit ? limit : (value < -limit ? -limit : value);
}

// 2^61 <= |value| < 2^62, the size of a Scaled's mantissa, from the upper word alone: false also at the very ends of the range.
constexpr bool is_surely_normal(int64_t value) {
  const auto high = static_cast<int32_t>(value >> 32);
  return static_cast<uint32_t>(high < 0 ? ~high : high) - 0x20000000u < 0x1fffffffu;
}

}  // namespace firmware
