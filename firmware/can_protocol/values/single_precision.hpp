// Block-floating numbers as IEEE 754 single precision, made from integers alone: the bit pattern travels on the bus.
//
// Arithmetic stated first:
//   rounding   once, to the nearest number, halves to the even one: what a conversion in hardware gives.
//   small      below 2^-126 subnormal numbers, below 2^-150 (and at it) zero with its sign.
//   large      from 2^128 - 2^103 on, where rounding leaves the range: infinity.
#pragma once
#include <cstdint>

#include "firmware/fixed_point/scaled.hpp"

namespace firmware {

constexpr uint32_t kNotANumberBits = 0x7FC00000;  // quiet, positive

uint32_t single_precision_bits(Scaled value);

}  // namespace firmware
