// Exact 64-bit division and square root from 32-bit multiplications: the two steps of block-floating arithmetic that a small
// processor has no instruction for. A PC divides with the instruction that it has: the floor is the floor.
//
// Both start from a reciprocal of some 15 bits, double its digits by Newton's steps (errors stated in wide.cpp), and end
// with the exact remainder: what comes out is the floor, never an approximation of it.
#pragma once
#include <cstdint>

namespace firmware {

struct Wide {  // high * 2^64 + low
  uint64_t high, low;
};

inline Wide multiply(uint64_t a, uint64_t b) {
#if defined(__SIZEOF_INT128__) && !defined(FIRMWARE_WITHOUT_INT128)
  const unsigned __int128 product = static_cast<unsigned __int128>(a) * b;
  return {static_cast<uint64_t>(product >> 64), static_cast<uint64_t>(product)};
#else
  const uint64_t a_low = a & 0xffffffffu, a_high = a >> 32, b_low = b & 0xffffffffu, b_high = b >> 32;
  const uint64_t low = a_low * b_low;
  const uint64_t middle = a_high * b_low + (low >> 32);
  const uint64_t cross = a_low * b_high + (middle & 0xffffffffu);
  return {a_high * b_high + (middle >> 32) + (cross >> 32), (cross << 32) | (low & 0xffffffffu)};
#endif
}

// floor(numerator / denominator) of a quotient below 2^bits, numerator and denominator 2^(bits - 1) below 2^64. Bit by bit where
// there is no instruction for it: as quick as the compiler's own for the few bits that are wanted, in a tenth of its room.
#if UINTPTR_MAX > UINT32_MAX
inline uint64_t short_quotient(uint64_t numerator, uint64_t denominator, int) { return numerator / denominator; }
#else
uint64_t short_quotient(uint64_t numerator, uint64_t denominator, int bits);
#endif

// floor(numerator * 2^62 / denominator) for numerator < denominator, 2^61 <= denominator < 2^63: by multiplications alone, and with
// the instruction for it where there is one.
uint64_t divide_by_steps(uint64_t numerator, uint64_t denominator);
inline uint64_t divide_fraction(uint64_t numerator, uint64_t denominator) {
#if defined(__x86_64__) && !defined(FIRMWARE_WITHOUT_INT128)
  uint64_t quotient, rest;  // the dividend's upper half, numerator / 4, is below the denominator
  __asm__("divq %4" : "=a"(quotient), "=d"(rest) : "a"(numerator << 62), "d"(numerator >> 2), "r"(denominator) : "cc");
  return quotient;
#else
  return divide_by_steps(numerator, denominator);
#endif
}

// 2^30 / sqrt(z / 2^32) for 2^30 <= z < 2^32, off by less than 2^-28 of itself.
uint32_t reciprocal_root(uint32_t z);

// The whole number nearest to sqrt(radicand * 2^56), 2^62 <= radicand < 2^64: 2^59 <= root <= 2^60.
uint64_t nearest_root(uint64_t radicand);

}  // namespace firmware
