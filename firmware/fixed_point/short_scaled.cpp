#include "firmware/fixed_point/short_scaled.hpp"

#include "firmware/fixed_point/magnitude.hpp"

namespace firmware {
namespace {

constexpr int kMantissaBits = 31;
constexpr int kDroppedBits = 62 - kMantissaBits;  // of a Scaled

}  // namespace

ShortScaled short_scaled(int64_t value, int32_t exponent) {
  if (value == 0) return {};
  uint64_t size = magnitude(value);
  const int shift = __builtin_clzll(size) - (64 - kMantissaBits);
  exponent -= shift;
  if (shift >= 0) {
    size <<= shift;
  } else {
    size = (size >> -shift) + ((size >> (-shift - 1)) & 1u);
    if (size >> kMantissaBits) {  // rounded up to the next power of two
      size >>= 1;
      ++exponent;
    }
  }
  const auto mantissa = static_cast<int32_t>(size);
  if (exponent > INT16_MAX) return {value < 0 ? -INT32_MAX : INT32_MAX, INT16_MAX};
  if (exponent < INT16_MIN) return {};
  return {value < 0 ? -mantissa : mantissa, static_cast<int16_t>(exponent)};
}

ShortScaled short_scaled(const Scaled& value) { return short_scaled(value.mantissa, value.exponent); }

Scaled long_scaled(ShortScaled value) {
  if (value.mantissa == 0) return {};
  return {value.mantissa * (int64_t{1} << kDroppedBits), value.exponent - kDroppedBits};
}

ShortScaled operator+(ShortScaled a, ShortScaled b) {
  if (a.mantissa == 0) return b;
  if (b.mantissa == 0) return a;
  if (a.exponent < b.exponent) {
    const ShortScaled swap = a;
    a = b;
    b = swap;
  }
  const int distance = a.exponent - b.exponent;
  if (distance > 2 * kMantissaBits) return a;
  const int64_t one = a.mantissa * (int64_t{1} << kMantissaBits), two = b.mantissa * (int64_t{1} << kMantissaBits);
  return short_scaled(one + (two >> distance), a.exponent - kMantissaBits);
}

}  // namespace firmware
