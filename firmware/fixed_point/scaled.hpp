// Block-floating numbers of the window-end arithmetic: value = mantissa * 2^exponent, all integer.
//
// Arithmetic stated first:
//   format   int64 mantissa, normalised so that 2^61 <= |mantissa| < 2^62 (or 0), int32 exponent.
//   guard    one bit above the mantissa: a sum of two aligned mantissas stays below 2^63.
//   error    each operation rounds once, relative error at most 2^-59.
//   range    exponents saturate at +-2^20; rigs with coefficients from 5e-6 to 1e9 use fewer than 2^8 of them.
// The per-sample path never uses this type: it works on exact integer codes and products.
#pragma once
#include <cstdint>
#include <type_traits>

#include "firmware/fixed_point/in_place.hpp"

namespace firmware {

#pragma pack(push, 4)  // 12 bytes, not 16: a core holds hundreds to thousands of them
struct Scaled {
  int64_t mantissa = 0;
  int32_t exponent = 0;

  static Scaled from_int(int64_t value, int32_t exponent);  // value * 2^exponent
  template <typename Whole>
  static Scaled from_int(Whole value) {
    return of(static_cast<Handed<Whole>>(value));
  }
  template <typename Numerator, typename Denominator>
  static Scaled ratio(Numerator numerator, Denominator denominator) {  // denominator != 0
    using Both = Handed<decltype(numerator + denominator)>;
    return ratio_of(static_cast<Both>(numerator), static_cast<Both>(denominator));
  }
  bool is_zero() const { return mantissa == 0; }
  bool is_negative() const { return mantissa < 0; }
  bool is_positive() const { return mantissa > 0; }

 private:
  // Most numbers are small: to hand them over as such takes half the instructions.
  template <typename Whole>
  using Handed = std::conditional_t<sizeof(Whole) < sizeof(int32_t) ||
                                        (sizeof(Whole) == sizeof(int32_t) && std::is_signed<Whole>::value),
                                    int32_t, int64_t>;
  static Scaled of(int64_t value);
  static Scaled of(int32_t value);
  static Scaled ratio_of(int64_t numerator, int64_t denominator);
  static Scaled ratio_of(int32_t numerator, int32_t denominator);
};
#pragma pack(pop)

inline constexpr Scaled kScaledOne = {int64_t{1} << 61, -61};

Scaled power_of_two(int32_t exponent);
Scaled operator+(const Scaled& a, const Scaled& b);
Scaled operator-(const Scaled& a, const Scaled& b);
Scaled operator-(const Scaled& a);
Scaled operator*(const Scaled& a, const Scaled& b);
Scaled square(const Scaled& a);
Scaled times(const Scaled& a, int64_t n);  // a * Scaled::from_int(n) with fewer steps; |n| < 2^62
Scaled operator/(const Scaled& a,
                 const Scaled& b);  // b == 0 gives the largest value with a's sign: callers test is_zero() first
Scaled quotient(const Scaled& a, const Scaled& b);  // a / b; of b == 0 it is 0
// With a whole number n that 32 bits hold: the bits of a * Scaled::from_int(n) and a / Scaled::from_int(n).
Scaled whole_times(const Scaled& a, int32_t n);
Scaled whole_part(const Scaled& a, int32_t n);
template <typename Whole>
using Fits32 = std::enable_if_t<std::is_integral<Whole>::value &&
                                (sizeof(Whole) < sizeof(int32_t) ||
                                 (sizeof(Whole) == sizeof(int32_t) && std::is_signed<Whole>::value))>;
template <typename Whole, typename = Fits32<Whole>>
Scaled operator*(const Scaled& a, Whole n) {
  return whole_times(a, static_cast<int32_t>(n));
}
template <typename Whole, typename = Fits32<Whole>>
Scaled operator/(const Scaled& a, Whole n) {
  return whole_part(a, static_cast<int32_t>(n));
}
// In place, which takes fewer instructions than a = a + b where that is asked for.
void operator+=(Scaled& a, const Scaled& b);
void operator-=(Scaled& a, const Scaled& b);
void operator*=(Scaled& a, const Scaled& b);
void operator/=(Scaled& a, const Scaled& b);
// sum += a * b and sum -= a * b, in one step each: most sums are of products.
void multiply_add(Scaled& sum, const Scaled& a, const Scaled& b);
void multiply_subtract(Scaled& sum, const Scaled& a, const Scaled& b);
Scaled sqrt(const Scaled& a);                              // a < 0 gives 0
Scaled root_of_squares(const Scaled& a, const Scaled& b);  // sqrt(a^2 + b^2)
Scaled inverse_root(const Scaled& a);  // 1 / sqrt(a) to 2^-28 of itself, in a tenth of the steps; a <= 0 gives 0
Scaled abs(const Scaled& a);
Scaled scale_by_power_of_two(const Scaled& a, int32_t power);
bool operator<(const Scaled& a, const Scaled& b);
bool operator>(const Scaled& a, const Scaled& b);
bool operator<=(const Scaled& a, const Scaled& b);
bool operator>=(const Scaled& a, const Scaled& b);
bool operator==(const Scaled& a, const Scaled& b);
bool exceeds(const Scaled& a, const Scaled& b);   // |a| > |b|
void keep_larger(Scaled& most, const Scaled& a);  // most becomes a where a > most

// a * 2^fraction_bits rounded to nearest (halves away from zero), saturated to +-(2^62 - 1).
int64_t to_fixed(const Scaled& a, int32_t fraction_bits);
// floor(log2 |a|); a == 0 gives the smallest int32.
int32_t log2_floor(const Scaled& a);

}  // namespace firmware

#ifdef FIRMWARE_IN_PLACE
#include "firmware/fixed_point/scaled_steps.hpp"
#endif
