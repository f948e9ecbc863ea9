// The exponential. On a PC it stands wherever it is used, so that vectors of numbers go through it; on a board once, in
// functions.cpp.
#pragma once
#include "firmware/fixed_point/functions.hpp"

#ifdef FIRMWARE_IN_PLACE
#define FIRMWARE_FUNCTION [[gnu::always_inline]] inline
#else
#define FIRMWARE_FUNCTION
#endif

namespace firmware {

template <int N>
constexpr Q30 polynomial(const Q30 (&coefficient)[N], Q30 x) {
  Q30 sum = coefficient[N - 1];
  for (int i = N - 2; i >= 0; --i) sum = coefficient[i] + rescale<Q30>(sum * x);
  return sum;
}

// Coefficients of 1, f, .. f^6 in 2^-f, 0 <= f <= 1: Chebyshev fit, 1.4e-9.
constexpr Q30 kExponential[7] = {{1073741823}, {-744260975}, {257938938}, {-59583046},
                                 {10286510},   {-1369790},   {117454}};

FIRMWARE_FUNCTION Q30 exp2_of_minus(Fixed<int64_t, 26> x) {
  const int64_t whole = x.raw >> 26;
  const Q30 fraction = Q30::from_raw(static_cast<int32_t>((x.raw & ((1 << 26) - 1)) << 4));
  const int32_t shifted = polynomial(kExponential, fraction).raw >> (whole & 31);
  return Q30::from_raw(whole > 31 ? 0 : shifted);
}

}  // namespace firmware
