#include "firmware/fixed_point/functions.hpp"

namespace firmware {
namespace {

// Coefficients of z, z^3, .. z^9 in sin(pi/2 z), |z| <= 1: Chebyshev fit, 3.4e-9.
constexpr Q30 kSine[5] = {{1686629673}, {-693597874}, {85564848}, {-5016757}, {161938}};
// Coefficients of 1, f, .. f^6 in 2^-f, 0 <= f <= 1: Chebyshev fit, 1.4e-9.
constexpr Q30 kExponential[7] = {{1073741823}, {-744260975}, {257938938}, {-59583046},
                                 {10286510},   {-1369790},   {117454}};

template <int N>
Q30 polynomial(const Q30 (&coefficient)[N], Q30 x) {
  Q30 sum = coefficient[N - 1];
  for (int i = N - 2; i >= 0; --i) sum = coefficient[i] + rescale<Q30>(sum * x);
  return sum;
}

}  // namespace

Q30 sine_of_turns(uint32_t turns) {
  // The half turn around pi is folded onto the one around 0: sin(pi - x) = sin(x).
  const uint32_t quarter = 0x40000000u;
  const uint32_t folded = turns - quarter < 2 * quarter ? 0x80000000u - turns : turns;
  const Q30 z = Q30::from_raw(static_cast<int32_t>(folded));
  const Q30 square = rescale<Q30>(z * z);
  return rescale<Q30>(polynomial(kSine, square) * z);
}

Q30 exp2_of_minus(Fixed<int64_t, 26> x) {
  const int64_t whole = x.raw >> 26;
  if (whole > 31) return {};
  const Q30 fraction = Q30::from_raw(static_cast<int32_t>((x.raw & ((1 << 26) - 1)) << 4));
  return Q30::from_raw(polynomial(kExponential, fraction).raw >> whole);
}

}  // namespace firmware
