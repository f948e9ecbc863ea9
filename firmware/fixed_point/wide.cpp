#include "firmware/fixed_point/wide.hpp"

namespace firmware {
namespace {

int leading_zeros(uint64_t value) { return __builtin_clzll(value); }  // value != 0

Wide subtract(Wide a, Wide b) { return {a.high - b.high - (a.low < b.low ? 1u : 0u), a.low - b.low}; }

// A difference of two Wide that is known to lie within +-2^127, divided by 2^bits and rounded down; 0 < bits < 64 + 63.
int64_t shifted(Wide difference, int bits) {
  const int64_t high = static_cast<int64_t>(difference.high);
  if (bits >= 64) return high >> (bits - 64);
  return static_cast<int64_t>((difference.high << (64 - bits)) | (difference.low >> bits));
}

// 2^126 / d for 2^63 <= d < 2^64, off by less than 2^-54 of itself.
uint64_t reciprocal(uint64_t d) {
  const uint32_t top = static_cast<uint32_t>(d >> 32);
  const uint32_t seed = 0xffffffffu / (top >> 16);  // 2^32 / (d >> 48): 2^-14.4 off
  // 2^63 / top by one step: the error squared, 2^-28.8, and what the shifts drop, 2^-30.
  const uint64_t first = static_cast<uint64_t>(seed) << 15;
  const int64_t first_error = static_cast<int64_t>((uint64_t{1} << 63) - top * first);
  const uint64_t second = first + static_cast<uint64_t>((static_cast<int64_t>(first) * (first_error >> 31)) >> 32);
  // And once more: |2^126 - d second 2^31| < 2^98.5, kept in steps of 2^68.
  const Wide whole = multiply(d, second << 31);
  const int64_t second_error = shifted(subtract({uint64_t{1} << 62, 0}, whole), 68);
  return (second << 31) + static_cast<uint64_t>((static_cast<int64_t>(second) * second_error) >> 27);
}

}  // namespace

// A line, 2^-3.7 off at its worst, and four of Newton's steps y (3 - z y^2) / 2.
uint32_t reciprocal_root(uint32_t z) {
  // 2.13 - 1.21 z on [1/4, 1]
  uint32_t y = static_cast<uint32_t>(2287070085u - ((uint64_t{1299227607u} * z) >> 32));
  for (int step = 0; step < 4; ++step) {
    const uint32_t square = static_cast<uint32_t>((static_cast<uint64_t>(y) * y) >> 31);        // Q29
    const uint32_t product = static_cast<uint32_t>((static_cast<uint64_t>(z) * square) >> 32);  // Q29, near 1
    y = static_cast<uint32_t>((static_cast<uint64_t>(y) * ((uint32_t{3} << 29) - product)) >> 30);
  }
  return y;
}

#if UINTPTR_MAX <= UINT32_MAX
uint64_t short_quotient(uint64_t numerator, uint64_t denominator, int bits) {
  uint64_t quotient = 0;
  uint64_t part = denominator << (bits - 1);
  for (int bit = 0; bit < bits; ++bit, part >>= 1) {
    quotient <<= 1;
    if (numerator < part) continue;
    numerator -= part;
    quotient |= 1u;
  }
  return quotient;
}
#endif

uint64_t divide_by_steps(uint64_t numerator, uint64_t denominator) {
  const int shift = leading_zeros(denominator);
  const uint64_t d = denominator << shift, n = numerator << shift;
  const uint64_t inverse = reciprocal(d);
  const Wide dividend = {n >> 2, n << 62};
  uint64_t quotient = multiply(n, inverse).high;  // within 2^8 of the quotient
  Wide rest = subtract(dividend, multiply(quotient, d));
  // rest / d = rest * inverse / 2^126, |rest| < 2^72
  quotient += static_cast<uint64_t>((shifted(rest, 42) * static_cast<int64_t>(inverse >> 33)) >> 51);
  rest = subtract(dividend, multiply(quotient, d));
  while (static_cast<int64_t>(rest.high) < 0) {
    --quotient;
    const uint64_t low = rest.low + d;
    rest.high += low < d ? 1u : 0u;
    rest.low = low;
  }
  while (rest.high != 0 || rest.low >= d) {
    ++quotient;
    rest = subtract(rest, {0, d});
  }
  return quotient;
}

uint64_t nearest_root(uint64_t radicand) {
  const uint32_t top = static_cast<uint32_t>(radicand >> 32);
  const int64_t y = reciprocal_root(top);
  const Wide square = {radicand >> 8, radicand << 56};
  // sqrt(z) 2^60 = z (1 / sqrt(z)) 2^60, then two of Heron's steps root += rest / (2 root), 1 / root = y / 2^90.
  uint64_t root = (static_cast<uint64_t>(top) * static_cast<uint64_t>(y)) >> 2;
  Wide rest = subtract(square, multiply(root, root));  // |rest| < 2^93
  root += static_cast<uint64_t>((shifted(rest, 63) * y) >> 28);
  rest = subtract(square, multiply(root, root));  // |rest| < 2^67
  root += static_cast<uint64_t>((shifted(rest, 36) * y) >> 55);
  rest = subtract(square, multiply(root, root));
  // Nearest: -root < rest <= root, in whole numbers.
  while (static_cast<int64_t>(rest.high) < 0 && (rest.high != ~uint64_t{0} || 0 - rest.low >= root)) {
    const Wide step = {0, 2 * root - 1};
    const uint64_t low = rest.low + step.low;
    rest.high += low < step.low ? 1u : 0u;
    rest.low = low;
    --root;
  }
  while (static_cast<int64_t>(rest.high) >= 0 && (rest.high != 0 || rest.low > root)) {
    rest = subtract(rest, {0, 2 * root + 1});
    ++root;
  }
  return root;
}

}  // namespace firmware
