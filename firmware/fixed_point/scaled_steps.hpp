// The steps of block-floating arithmetic. On a PC they stand wherever they are used (scaled.hpp includes this), for a call and the
// way there and back through memory take longer than the steps do; on a board they stand once, in scaled.cpp: there flash counts.
// The 128-bit steps are in wide.hpp.
#pragma once
#include "firmware/fixed_point/magnitude.hpp"
#include "firmware/fixed_point/scaled.hpp"
#include "firmware/fixed_point/wide.hpp"
#include "firmware/fixed_point/work_meter.hpp"

#ifdef FIRMWARE_IN_PLACE
#define FIRMWARE_STEP [[gnu::always_inline]] inline
#define FIRMWARE_STEP_APART FIRMWARE_STEP
#define FIRMWARE_STEP_ALONE FIRMWARE_STEP
#else
#define FIRMWARE_STEP
#define FIRMWARE_STEP_APART [[gnu::noinline]] static
#define FIRMWARE_STEP_ALONE [[gnu::noinline]]  // other steps call it: it is not copied into them
#endif

namespace firmware {
namespace scaled_steps {

constexpr int kMantissaBits = 62;  // |mantissa| < 2^62
constexpr int32_t kExponentLimit = 1 << 20;
// What they take on a small processor, for what is done in slices.
constexpr int32_t kProductWork = 150, kQuotientWork = 800;
constexpr int64_t kLargestMantissa = (int64_t{1} << kMantissaBits) - 1;

inline int64_t with_sign(uint64_t value, bool negative) {
  return negative ? -static_cast<int64_t>(value) : static_cast<int64_t>(value);
}

// Places that a number below 2^64 may move up, or (negative) has to move down, to its normal form; value != 0.
inline int places_up(uint64_t value) { return __builtin_clzll(value) - (64 - kMantissaBits); }

// A mantissa in its normal form, its exponent saturated.
inline Scaled saturated(uint64_t value, int32_t exponent, bool negative) {
  if (exponent > kExponentLimit) return {with_sign(static_cast<uint64_t>(kLargestMantissa), negative), kExponentLimit};
  if (exponent < -kExponentLimit) return {};
  return {with_sign(value, negative), exponent};
}

#if UINTPTR_MAX > UINT32_MAX
[[gnu::always_inline]] inline Scaled limited(uint64_t value, int32_t exponent, bool negative) {
  const uint32_t above_least = static_cast<uint32_t>(exponent) + static_cast<uint32_t>(kExponentLimit);
  if (__builtin_expect(above_least > 2 * static_cast<uint32_t>(kExponentLimit), 0))
    return saturated(value, exponent, negative);
  return {with_sign(value, negative), exponent};
}

// value * 2^exponent with 0 < value < 2^63, brought to the normal form. Without a branch that depends on the numbers: which way they go
// is chance, and a wide processor loses more by a wrong guess than by all the steps. All bits but one stand above the binary point
// first; of a value that had to move up the last bit is 0, and nothing is rounded.
[[gnu::always_inline]] inline Scaled brought_to_form(uint64_t value, int32_t exponent, bool negative) {
  const int up = __builtin_clzll(value) - 1;
  uint64_t normal = ((value << up) + 1) >> 1;  // to nearest; 2^61 <= normal <= 2^62
  exponent += 1 - up;
  if (__builtin_expect(static_cast<long>(normal >> kMantissaBits), 0)) {  // rounded up to the next power of two
    normal >>= 1;
    ++exponent;
  }
  return limited(normal, exponent, negative);
}

// value * 2^exponent with value < 2^64; rounds to nearest when bits are dropped.
FIRMWARE_STEP_APART Scaled normalised(uint64_t value, int32_t exponent, bool negative) {
  if (value == 0) return {};
  if (value >> 63) {
    value = (value >> 2) + ((value >> 1) & 1u);
    exponent += 2;
  }
  return brought_to_form(value, exponent, negative);
}

// Mantissas of 62 bits, larger_exponent - smaller_exponent = distance >= 0.
[[gnu::always_inline]] inline Scaled aligned_sum(int64_t larger, int32_t exponent, int64_t smaller, int32_t distance) {
  if (distance > kMantissaBits) return {larger, exponent};
  const int64_t sum = larger + ((((smaller * 2) >> distance) + 1) >> 1);  // to nearest
  if (sum == 0) return {};
  return brought_to_form(magnitude(sum), exponent, sum < 0);
}
#else
[[gnu::always_inline]] inline Scaled limited(uint64_t value, int32_t exponent, bool negative) {
  return saturated(value, exponent, negative);
}

// value * 2^exponent with value < 2^64, brought to the normal form; rounds to nearest when bits are dropped.
FIRMWARE_STEP_APART Scaled normalised(uint64_t value, int32_t exponent, bool negative) {
  if (value == 0) return {};
  const int shift = places_up(value);
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

// Mantissas of 62 bits, larger_exponent - smaller_exponent = distance >= 0.
[[gnu::always_inline]] inline Scaled aligned_sum(int64_t larger, int32_t exponent, int64_t smaller, int32_t distance) {
  if (distance > kMantissaBits) return {larger, exponent};
  if (distance > 0) smaller = ((smaller >> (distance - 1)) + 1) >> 1;  // to nearest
  const int64_t sum = larger + smaller;
  if (is_surely_normal(sum)) return {sum, exponent};
  if (sum == 0) return {};
  uint64_t value = magnitude(sum);  // below 2^63
  const int shift = places_up(value);
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

[[gnu::always_inline]] inline Scaled any_sum(int64_t a, int32_t a_exponent, int64_t b, int32_t b_exponent) {
  const int32_t distance = a_exponent - b_exponent;
  const bool swap = distance < 0;
  return aligned_sum(swap ? b : a, swap ? b_exponent : a_exponent, swap ? a : b, swap ? -distance : distance);
}

// In place: a becomes a + b, where b is negated a - b. All four operators are this one.
FIRMWARE_STEP_APART void add_to(Scaled& a, const Scaled& b, bool negated) {
  if (b.mantissa == 0) return;
  const int64_t addend = negated ? -b.mantissa : b.mantissa;
  a = a.mantissa == 0 ? Scaled{addend, b.exponent} : any_sum(a.mantissa, a.exponent, addend, b.exponent);
}

// Of two normal mantissas.
[[gnu::always_inline]] inline Scaled product(uint64_t a, uint64_t b, int32_t exponent, bool negative) {
  exponent += 61;
#if UINTPTR_MAX > UINT32_MAX
  const uint64_t top = multiply(a << 2, b << 2).high;  // product / 2^60, 2^62 <= top < 2^64
  const int large = static_cast<int>(top >> 63);
  uint64_t value = ((top >> large) + 1) >> 1;  // to nearest; 2^61 <= value <= 2^62
  exponent += large;
#else
  const Wide product = multiply(a, b);                             // 2^122 <= product < 2^124
  const uint64_t top = (product.high << 4) | (product.low >> 60);  // product / 2^60, 2^62 <= top < 2^64
  uint64_t value = (top >> 1) + (top & 1u);                        // to nearest; 2^61 <= value <= 2^63
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

FIRMWARE_STEP_APART Scaled unreported_product(const Scaled& a, const Scaled& b) {
  if (a.mantissa == 0 || b.mantissa == 0) return {};
  return product(magnitude(a.mantissa), magnitude(b.mantissa), a.exponent + b.exponent,
                 (a.mantissa < 0) != (b.mantissa < 0));
}
[[gnu::noinline, gnu::cold]] inline Scaled reported_product(const Scaled& a, const Scaled& b) {
  report_work(kProductWork);
  return unreported_product(a, b);
}

}  // namespace scaled_steps

FIRMWARE_STEP Scaled Scaled::from_int(int64_t value, int32_t exponent) {
  return scaled_steps::normalised(magnitude(value), exponent, value < 0);
}

FIRMWARE_STEP Scaled power_of_two(int32_t exponent) { return Scaled::from_int(1, exponent); }
FIRMWARE_STEP Scaled Scaled::of(int64_t value) { return from_int(value, 0); }
FIRMWARE_STEP Scaled Scaled::of(int32_t value) { return from_int(int64_t{value}, 0); }
FIRMWARE_STEP Scaled Scaled::ratio_of(int64_t numerator, int64_t denominator) {
  return of(numerator) / of(denominator);
}
FIRMWARE_STEP Scaled Scaled::ratio_of(int32_t numerator, int32_t denominator) {
  return ratio_of(int64_t{numerator}, int64_t{denominator});
}

FIRMWARE_STEP void operator+=(Scaled& a, const Scaled& b) { scaled_steps::add_to(a, b, false); }
FIRMWARE_STEP void operator-=(Scaled& a, const Scaled& b) { scaled_steps::add_to(a, b, true); }
FIRMWARE_STEP Scaled operator+(const Scaled& a, const Scaled& b) {
  Scaled sum = a;
  scaled_steps::add_to(sum, b, false);
  return sum;
}
FIRMWARE_STEP Scaled operator-(const Scaled& a, const Scaled& b) {
  Scaled difference = a;
  scaled_steps::add_to(difference, b, true);
  return difference;
}
FIRMWARE_STEP Scaled operator-(const Scaled& a) { return {-a.mantissa, a.exponent}; }

FIRMWARE_STEP Scaled operator*(const Scaled& a, const Scaled& b) {
  return work_meter == nullptr ? scaled_steps::unreported_product(a, b) : scaled_steps::reported_product(a, b);
}

FIRMWARE_STEP Scaled square(const Scaled& a) { return a * a; }

FIRMWARE_STEP void multiply_add(Scaled& sum, const Scaled& a, const Scaled& b) { sum += a * b; }
FIRMWARE_STEP void multiply_subtract(Scaled& sum, const Scaled& a, const Scaled& b) { sum -= a * b; }

FIRMWARE_STEP Scaled times(const Scaled& a, int64_t n) {
  if (n == 0) return {};
  const int shift = scaled_steps::places_up(magnitude(n));
  return scaled_steps::unreported_product(a, {n * (int64_t{1} << shift), -shift});
}

FIRMWARE_STEP Scaled operator/(const Scaled& a, const Scaled& b) {
  report_work(scaled_steps::kQuotientWork);
  if (a.mantissa == 0) return {};
  const bool negative = (a.mantissa < 0) != (b.mantissa < 0);
  if (b.mantissa == 0)
    return {scaled_steps::with_sign(static_cast<uint64_t>(scaled_steps::kLargestMantissa), a.mantissa < 0),
            scaled_steps::kExponentLimit};
  // Normal mantissas differ by less than a factor of 2: halving a, where needed, makes a proper fraction of at least 1/2.
  const uint64_t numerator = magnitude(a.mantissa);
  const int halve = numerator >= magnitude(b.mantissa) ? 1 : 0;
  const uint64_t quotient = divide_fraction(numerator, magnitude(b.mantissa) << halve);
  return scaled_steps::normalised(quotient, a.exponent - b.exponent - scaled_steps::kMantissaBits + halve, negative);
}

FIRMWARE_STEP Scaled quotient(const Scaled& a, const Scaled& b) { return b.is_zero() ? Scaled{} : a / b; }

FIRMWARE_STEP Scaled whole_times(const Scaled& a, int32_t n) { return a * Scaled::from_int(n); }
FIRMWARE_STEP Scaled whole_part(const Scaled& a, int32_t n) { return a / Scaled::from_int(n); }

FIRMWARE_STEP void operator*=(Scaled& a, const Scaled& b) { a = a * b; }
FIRMWARE_STEP void operator/=(Scaled& a, const Scaled& b) { a = a / b; }

FIRMWARE_STEP Scaled abs(const Scaled& a) { return a.mantissa < 0 ? -a : a; }

FIRMWARE_STEP Scaled scale_by_power_of_two(const Scaled& a, int32_t power) {
  return a.mantissa == 0 ? a : scaled_steps::normalised(magnitude(a.mantissa), a.exponent + power, a.mantissa < 0);
}

// Of two normal numbers of one sign the larger exponent is farther from 0.
FIRMWARE_STEP_ALONE bool operator<(const Scaled& a, const Scaled& b) {
  const bool one_sign = a.mantissa != 0 && b.mantissa != 0 && (a.mantissa < 0) == (b.mantissa < 0);
  if (one_sign && a.exponent != b.exponent) return (a.exponent < b.exponent) != (a.mantissa < 0);
  return a.mantissa < b.mantissa;
}
FIRMWARE_STEP bool operator>(const Scaled& a, const Scaled& b) { return b < a; }
FIRMWARE_STEP bool operator<=(const Scaled& a, const Scaled& b) { return !(b < a); }
FIRMWARE_STEP bool operator>=(const Scaled& a, const Scaled& b) { return !(a < b); }
FIRMWARE_STEP bool exceeds(const Scaled& a, const Scaled& b) {
  if (a.mantissa == 0 || b.mantissa == 0 || a.exponent == b.exponent)
    return magnitude(a.mantissa) > magnitude(b.mantissa);
  return a.exponent > b.exponent;
}
FIRMWARE_STEP void keep_larger(Scaled& most, const Scaled& a) {
  if (a > most) most = a;
}
FIRMWARE_STEP bool operator==(const Scaled& a, const Scaled& b) {
  return a.mantissa == b.mantissa && (a.mantissa == 0 || a.exponent == b.exponent);
}

}  // namespace firmware
