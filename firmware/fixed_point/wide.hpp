// Exact 64-bit division and square root from 32-bit multiplications: the two steps of scaled.cpp that a small processor
// has no instruction for. One path on every machine, so that the bits are the same everywhere.
//
// Both start from a reciprocal of some 15 bits, double its digits by Newton's steps (errors stated in wide.cpp), and end
// with the exact remainder: what comes out is the floor, never an approximation of it.
#pragma once
#include <cstdint>

namespace firmware {

struct Wide {  // high * 2^64 + low
  uint64_t high, low;
};

Wide multiply(uint64_t a, uint64_t b);

// floor(numerator * 2^62 / denominator) for numerator < denominator, 2^61 <= denominator < 2^63.
uint64_t divide_fraction(uint64_t numerator, uint64_t denominator);

// The whole number nearest to sqrt(radicand * 2^56), 2^62 <= radicand < 2^64: 2^59 <= root <= 2^60.
uint64_t nearest_root(uint64_t radicand);

}  // namespace firmware
