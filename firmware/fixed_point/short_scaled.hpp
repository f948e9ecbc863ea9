// Block-floating numbers of half the size of Scaled, for long tables and sums of many products.
//
//   format   int32 mantissa, 2^30 <= |mantissa| < 2^31 (or 0), int16 exponent; value = mantissa * 2^exponent
//   error    rounded once to nearest, at most 2^-31 of itself
//   sums     of products are exact to 2^-57 of the largest of them: 62 bits each, aligned to it and added in int64
#pragma once
#include <cstdint>

#include "firmware/fixed_point/scaled.hpp"

namespace firmware {

struct ShortScaled {
  int32_t mantissa = 0;
  int16_t exponent = 0;
};

ShortScaled short_scaled(int64_t value, int32_t exponent = 0);  // value * 2^exponent
ShortScaled short_scaled(const Scaled& value);
Scaled long_scaled(ShortScaled value);
ShortScaled operator+(ShortScaled a, ShortScaled b);

// Bits by which `count` numbers of equal size may outgrow one.
constexpr int bits_of_sum(int count) {
  int bits = 0;
  while ((1 << bits) < count) ++bits;
  return bits;
}

// Sum of a(i) * b(i), 0 <= i < count, both of ShortScaled; count below 2^16. In two passes, which look at each number twice.
template <typename A, typename B>
Scaled sum_in_two_passes(int count, A a, B b) {
  int32_t largest = INT32_MIN;
  for (int i = 0; i < count; ++i) {
    const ShortScaled x = a(i), y = b(i);
    const int32_t exponent = x.exponent + y.exponent;
    if (x.mantissa != 0 && y.mantissa != 0 && exponent > largest) largest = exponent;
  }
  if (largest == INT32_MIN) return {};
  largest += bits_of_sum(count);
  int64_t sum = 0;
  for (int i = 0; i < count; ++i) {
    const ShortScaled x = a(i), y = b(i);
    const int32_t shift = largest - (x.exponent + y.exponent);
    if (shift < 63 && shift >= 0) sum += (static_cast<int64_t>(x.mantissa) * y.mantissa) >> shift;
  }
  return Scaled::from_int(sum, largest);
}

// The same, where there is room to keep count <= kMost products: each number is looked up once, and no branch depends on it.
template <int kMost, typename A, typename B>
Scaled sum_of_kept(int count, A a, B b) {
  int64_t product[kMost];
  int32_t exponent[kMost], largest = INT32_MIN;
  for (int i = 0; i < count; ++i) {
    const ShortScaled x = a(i), y = b(i);
    product[i] = static_cast<int64_t>(x.mantissa) * y.mantissa;
    exponent[i] = x.exponent + y.exponent;
    const int32_t counts = product[i] != 0 ? exponent[i] : INT32_MIN;
    largest = counts > largest ? counts : largest;
  }
  if (largest == INT32_MIN) return {};
  largest += bits_of_sum(count);
  int64_t sum = 0;
  for (int i = 0; i < count; ++i) {
    const auto shift = static_cast<uint32_t>(largest - exponent[i]);  // of a product that is 0 anything
    const int64_t shifted = product[i] >> (shift & 63u);
    sum += shift < 63 ? shifted : 0;
  }
  return Scaled::from_int(sum, largest);
}

#ifdef FIRMWARE_IN_PLACE
template <int kMost, typename A, typename B>
Scaled sum_of_products(int count, A a, B b) {
  return sum_of_kept<kMost>(count, a, b);
}
#endif

}  // namespace firmware
