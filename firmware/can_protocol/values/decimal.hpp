// Block-floating numbers to decimal mantissa and exponent, so that a person can read what travels on the bus.
//
// Arithmetic stated first:
//   input      Scaled, |value| between 2^-(2^20) and 2^(2^20), or 0
//   product    value times or divided by a power of ten: 10^e with |e| <= 26 is exact (5^26 < 2^61), so one rounding,
//              2^-60
//   output     mantissa rounded to the nearest integer, halves away from zero; integers alone, so the same on every
//              board
//   overflow   at the largest exponent allowed the mantissa saturates at the limit
#pragma once
#include <cstdint>

#include "firmware/fixed_point/scaled.hpp"

namespace firmware {

struct Decimal {
  int64_t mantissa = 0;
  int32_t exponent = 0;  // value = mantissa * 10^exponent
};

// The finest form: the smallest exponent of lowest .. highest (both within +-26) whose mantissa does not exceed the
// limit. limit < 2^61. Zero gives {0, lowest}.
Decimal to_decimal(Scaled value, int64_t limit, int32_t lowest, int32_t highest);

// value / 10^exponent rounded to an integer, saturated at +-limit.
int64_t decimal_mantissa(Scaled value, int32_t exponent, int64_t limit);

Scaled from_decimal(Decimal decimal);

}  // namespace firmware
