// See sine.hpp for the equation and its error.
#include "firmware/excitation/sine.hpp"

namespace firmware {
namespace {

using Q30 = Fixed<int32_t, 30>;

// Coefficients of z, z^3, z^5, z^7, z^9: least-maximum fit of sin(pi/2 z), times 2^30.
constexpr Q30 kCoefficients[5] = {{1686629681}, {-693597962}, {85565130}, {-5017109}, {162087}};

Q30 fold(uint32_t phase_turns) {
  const int32_t quarter = 1 << 30;
  const auto signed_phase = static_cast<int32_t>(phase_turns);
  if (signed_phase > quarter) return Q30::from_raw(static_cast<int32_t>(0x80000000u - phase_turns));
  if (signed_phase < -quarter) return Q30::from_raw(static_cast<int32_t>(0x80000000u - phase_turns));
  return Q30::from_raw(signed_phase);
}

}  // namespace

Drive sine(uint32_t phase_turns) {
  const Q30 z = fold(phase_turns);
  const Q30 square = rescale<Q30>(z * z);
  Q30 sum = kCoefficients[4];
  for (int i = 3; i >= 0; --i) sum = kCoefficients[i] + rescale<Q30>(sum * square);
  const int64_t product = (sum * z).raw;  // Q60
  return Drive::from_raw(clamp_magnitude((product + (int64_t{1} << 28)) >> 29, INT32_MAX));
}

}  // namespace firmware
