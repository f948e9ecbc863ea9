// Block-floating arithmetic; its 128-bit steps are in wide.cpp.
#include "firmware/fixed_point/scaled.hpp"

#include "firmware/fixed_point/magnitude.hpp"
#include "firmware/fixed_point/wide.hpp"
#include "firmware/fixed_point/work_meter.hpp"

namespace firmware {
namespace {

constexpr int kMantissaBits = 62;  // |mantissa| < 2^62
constexpr int32_t kExponentLimit = 1 << 20;
// What they take on a small processor, for what is done in slices.
constexpr int32_t kProductWork = 150, kQuotientWork = 800, kRootWork = 1000;
constexpr int64_t kLargestMantissa = (int64_t{1} << kMantissaBits) - 1;

int64_t with_sign(uint64_t value, bool negative) {
  return negative ? -static_cast<int64_t>(value) : static_cast<int64_t>(value);
}

int leading_zeros(uint64_t value) { return __builtin_clzll(value); }  // value != 0

// A mantissa in its normal form, its exponent saturated.
Scaled limited(uint64_t value, int32_t exponent, bool negative) {
  if (exponent > kExponentLimit) return {with_sign(static_cast<uint64_t>(kLargestMantissa), negative), kExponentLimit};
  if (exponent < -kExponentLimit) return {};
  return {with_sign(value, negative), exponent};
}

// value * 2^exponent with value < 2^64, brought to the normal form; rounds to nearest when bits are dropped.
Scaled normalised(uint64_t value, int32_t exponent, bool negative) {
  if (value == 0) return {};
  const int shift = leading_zeros(value) - (64 - kMantissaBits);
  if (shift >= 0) {
    value <<= shift;
  } else {
    const int drop = -shift;
    value = (value >> drop) + ((value >> (drop - 1)) & 1u);
    if (value >> kMantissaBits) {
      value >>= 1;
      ++exponent;
    }
  }
  return limited(value, exponent - shift, negative);
}

}  // namespace

Scaled Scaled::from_int(int64_t value, int32_t exponent) { return normalised(magnitude(value), exponent, value < 0); }

Scaled Scaled::of(int64_t value) { return from_int(value, 0); }
Scaled Scaled::of(int32_t value) { return from_int(int64_t{value}, 0); }
Scaled Scaled::ratio_of(int64_t numerator, int64_t denominator) { return of(numerator) / of(denominator); }
Scaled Scaled::ratio_of(int32_t numerator, int32_t denominator) { return of(numerator) / of(denominator); }

// Mantissas of 62 bits, larger_exponent - smaller_exponent = distance >= 0.
#if UINTPTR_MAX > UINT32_MAX
// Without a branch that depends on the numbers: which way they go is chance, and a wide processor loses more by a wrong guess
// than by all the steps.
[[gnu::always_inline]] static inline Scaled aligned_sum(int64_t larger, int32_t exponent, int64_t smaller,
                                                        int32_t distance) {
  if (distance > kMantissaBits) return {larger, exponent};
  const int64_t sum = larger + ((((smaller * 2) >> distance) + 1) >> 1);  // to nearest
  if (sum == 0) return {};
  const uint64_t value = magnitude(sum);  // below 2^63
  const int grown = static_cast<int>(value >> kMantissaBits);
  const int shift = grown != 0 ? 0 : leading_zeros(value) - (64 - kMantissaBits);
  uint64_t normal = ((value >> grown) + (value & static_cast<uint64_t>(grown))) << shift;
  exponent += grown - shift;
  const int rounded_up = static_cast<int>(normal >> kMantissaBits);
  normal >>= rounded_up;
  return limited(normal, exponent + rounded_up, sum < 0);
}
#else
[[gnu::always_inline]] static inline Scaled aligned_sum(int64_t larger, int32_t exponent, int64_t smaller,
                                                        int32_t distance) {
  if (distance > kMantissaBits) return {larger, exponent};
  if (distance > 0) smaller = ((smaller >> (distance - 1)) + 1) >> 1;  // to nearest
  const int64_t sum = larger + smaller;
  if (is_surely_normal(sum)) return {sum, exponent};
  if (sum == 0) return {};
  uint64_t value = magnitude(sum);  // below 2^63
  const int shift = leading_zeros(value) - (64 - kMantissaBits);
  if (shift >= 0) {
    value <<= shift;
    exponent -= shift;
  } else {
    value = (value >> 1) + (value & 1u);
    ++exponent;
    if (value >> kMantissaBits) {
      value >>= 1;
      ++exponent;
    }
  }
  return limited(value, exponent, sum < 0);
}
#endif

[[gnu::always_inline]] static inline Scaled any_sum(int64_t a, int32_t a_exponent, int64_t b, int32_t b_exponent) {
  const int32_t distance = a_exponent - b_exponent;
  const bool swap = distance < 0;
  return aligned_sum(swap ? b : a, swap ? b_exponent : a_exponent, swap ? a : b, swap ? -distance : distance);
}

Scaled operator+(const Scaled& a, const Scaled& b) {
  if (a.mantissa == 0) return b;
  if (b.mantissa == 0) return a;
  return any_sum(a.mantissa, a.exponent, b.mantissa, b.exponent);
}

Scaled operator-(const Scaled& a) { return {-a.mantissa, a.exponent}; }
Scaled operator-(const Scaled& a, const Scaled& b) {
  if (a.mantissa == 0) return -b;
  if (b.mantissa == 0) return a;
  return any_sum(a.mantissa, a.exponent, -b.mantissa, b.exponent);
}

// Of two normal mantissas.
[[gnu::always_inline]] static inline Scaled product(uint64_t a, uint64_t b, int32_t exponent, bool negative) {
  const Wide product = multiply(a, b);                             // 2^122 <= product < 2^124
  const uint64_t top = (product.high << 4) | (product.low >> 60);  // product / 2^60, 2^62 <= top < 2^64
  exponent += 61;
#if UINTPTR_MAX > UINT32_MAX
  const int large = static_cast<int>(top >> 63);
  uint64_t value = (top >> (1 + large)) + ((top >> large) & 1u);  // to nearest; 2^61 <= value <= 2^63
  exponent += large;
#else
  uint64_t value = (top >> 1) + (top & 1u);  // to nearest; 2^61 <= value <= 2^63
  if (top >> 63) {
    value = (top >> 2) + ((top >> 1) & 1u);
    ++exponent;
  }
#endif
  if (value >> kMantissaBits) {  // rounded up to the next power of two
    value >>= 1;
    ++exponent;
  }
  return limited(value, exponent, negative);
}

[[gnu::noinline]] static Scaled unreported_product(const Scaled& a, const Scaled& b) {
  if (a.mantissa == 0 || b.mantissa == 0) return {};
  return product(magnitude(a.mantissa), magnitude(b.mantissa), a.exponent + b.exponent,
                 (a.mantissa < 0) != (b.mantissa < 0));
}
[[gnu::noinline, gnu::cold]] static Scaled reported_product(const Scaled& a, const Scaled& b) {
  report_work(kProductWork);
  return unreported_product(a, b);
}
Scaled operator*(const Scaled& a, const Scaled& b) {
  return work_meter == nullptr ? unreported_product(a, b) : reported_product(a, b);
}

Scaled times(const Scaled& a, int64_t n) {
  if (a.mantissa == 0 || n == 0) return {};
  const uint64_t value = magnitude(n);
  const int shift = leading_zeros(value) - (64 - kMantissaBits);
  return product(magnitude(a.mantissa), value << shift, a.exponent - shift, (a.mantissa < 0) != (n < 0));
}

Scaled operator/(const Scaled& a, const Scaled& b) {
  report_work(kQuotientWork);
  if (a.mantissa == 0) return {};
  const bool negative = (a.mantissa < 0) != (b.mantissa < 0);
  if (b.mantissa == 0) return {with_sign(static_cast<uint64_t>(kLargestMantissa), a.mantissa < 0), kExponentLimit};
  // Normal mantissas differ by less than a factor of 2: halving a, where needed, makes a proper fraction of at least 1/2.
  const uint64_t numerator = magnitude(a.mantissa);
  const int halve = numerator >= magnitude(b.mantissa) ? 1 : 0;
  const uint64_t quotient = divide_fraction(numerator, magnitude(b.mantissa) << halve);
  return normalised(quotient, a.exponent - b.exponent - kMantissaBits + halve, negative);
}

void operator+=(Scaled& a, const Scaled& b) { a = a + b; }
void operator-=(Scaled& a, const Scaled& b) { a = a - b; }
void operator*=(Scaled& a, const Scaled& b) { a = a * b; }
void operator/=(Scaled& a, const Scaled& b) { a = a / b; }

Scaled sqrt(const Scaled& a) {
  report_work(kRootWork);
  if (a.mantissa <= 0) return {};
  // Even exponent: mantissa * 2^(60 - drop) = radicand * 2^56 has 119 or 120 bits, its root 60.
  const int drop = (a.exponent & 1) ? 3 : 2;
  const uint64_t root = nearest_root(static_cast<uint64_t>(a.mantissa) << (4 - drop));
  return normalised(root, (a.exponent + drop - 60) / 2, false);
}

Scaled inverse_root(const Scaled& a) {
  report_work(kProductWork);
  if (a.mantissa <= 0) return {};
  // a = z 2^(exponent - n), z = mantissa 2^n / 2^32 of 31 or 32 bits, the exponent even.
  const int up = (a.exponent & 1) ? 1 : 2;
  const uint32_t z = static_cast<uint32_t>((static_cast<uint64_t>(a.mantissa) << up) >> 32);
  return Scaled::from_int(reciprocal_root(z), -30 - (a.exponent - up + 64) / 2);
}

Scaled abs(const Scaled& a) { return a.mantissa < 0 ? -a : a; }

Scaled scale_by_power_of_two(const Scaled& a, int32_t power) {
  return a.mantissa == 0 ? a : normalised(magnitude(a.mantissa), a.exponent + power, a.mantissa < 0);
}

// Of two normal numbers of one sign the larger exponent is farther from 0.
bool operator<(const Scaled& a, const Scaled& b) {
  const bool one_sign = a.mantissa != 0 && b.mantissa != 0 && (a.mantissa < 0) == (b.mantissa < 0);
  if (one_sign && a.exponent != b.exponent) return (a.exponent < b.exponent) != (a.mantissa < 0);
  return a.mantissa < b.mantissa;
}
bool operator>(const Scaled& a, const Scaled& b) { return b < a; }
bool operator<=(const Scaled& a, const Scaled& b) { return !(b < a); }
bool operator>=(const Scaled& a, const Scaled& b) { return !(a < b); }
bool operator==(const Scaled& a, const Scaled& b) {
  return a.mantissa == b.mantissa && (a.mantissa == 0 || a.exponent == b.exponent);
}

int64_t to_fixed(const Scaled& a, int32_t fraction_bits) {
  if (a.mantissa == 0) return 0;
  const int64_t shift = static_cast<int64_t>(a.exponent) + fraction_bits;
  if (shift >= 1) return a.mantissa < 0 ? -kLargestMantissa : kLargestMantissa;
  if (shift == 0) return a.mantissa;
  if (shift < -kMantissaBits) return 0;
  const uint64_t value = magnitude(a.mantissa);
  const int drop = static_cast<int>(-shift);
  return with_sign((value >> drop) + ((value >> (drop - 1)) & 1u), a.mantissa < 0);
}

int32_t log2_floor(const Scaled& a) { return a.mantissa == 0 ? INT32_MIN : a.exponent + kMantissaBits - 1; }

}  // namespace firmware
