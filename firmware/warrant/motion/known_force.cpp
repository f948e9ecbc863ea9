#include "firmware/warrant/motion/known_force.hpp"

#include "firmware/links/node_difference.hpp"

namespace firmware {

void KnownForce::add(int dof, int column, const Scaled& coefficient) {
  if (shares_ == kMaxShares) return;
  share_[shares_].dof = static_cast<uint8_t>(dof);
  share_[shares_].column = static_cast<uint8_t>(column);
  coefficient_[shares_++] = coefficient;
}

// Full scale of every term at once stays within 2^27 units.
Scaled KnownForce::scale(int dof, const Scaled* column_unit, bool has_force, int32_t force_exponent) {
  Scaled most = has_force ? power_of_two(force_exponent) : Scaled{};
  for (int s = 0; s < shares_; ++s)
    if (share_[s].dof == dof)
      multiply_add(most, abs(coefficient_[s]) * column_unit[share_[s].column], power_of_two(kDifferenceFraction + 1));
  if (most.is_zero()) most = kScaledOne;
  const Scaled unit = power_of_two(log2_floor(most) + 1 - kKnownFraction);
  for (int s = 0; s < shares_; ++s) {
    if (share_[s].dof != dof) continue;
    const Scaled ratio = coefficient_[s] * column_unit[share_[s].column] / unit;
    const int shift = ratio.is_zero() ? 0 : 29 - log2_floor(ratio);
    share_[s].shift = static_cast<int8_t>(shift > 62 ? 0 : (shift < 0 ? 0 : shift));
    share_[s].mantissa = shift > 62 ? 0 : static_cast<int32_t>(to_fixed(ratio, share_[s].shift));
  }
  return unit;
}

void KnownForce::add_to(int dof, const int32_t (*column)[kBlockSamples], int64_t* known) const {
  for (int s = 0; s < shares_; ++s) {
    if (share_[s].dof != dof) continue;
    const int32_t* of = column[share_[s].column];
    for (int n = 0; n < kBlockSamples; ++n) known[n] += (int64_t{of[n]} * share_[s].mantissa) >> share_[s].shift;
  }
}

}  // namespace firmware
