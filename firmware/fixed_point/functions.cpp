#include "firmware/fixed_point/functions.hpp"

#include "firmware/fixed_point/exponential.hpp"

namespace firmware {
namespace {

// Coefficients of z, z^3, .. z^9 in sin(pi/2 z), |z| <= 1: Chebyshev fit, 3.4e-9.
constexpr Q30 kSine[5] = {{1686629673}, {-693597874}, {85564848}, {-5016757}, {161938}};
}  // namespace

Q30 sine_of_turns(uint32_t turns) {
  // The half turn around pi is folded onto the one around 0: sin(pi - x) = sin(x).
  const uint32_t quarter = 0x40000000u;
  const uint32_t folded = turns - quarter < 2 * quarter ? 0x80000000u - turns : turns;
  const Q30 z = Q30::from_raw(static_cast<int32_t>(folded));
  const Q30 square = rescale<Q30>(z * z);
  return rescale<Q30>(polynomial(kSine, square) * z);
}

}  // namespace firmware
