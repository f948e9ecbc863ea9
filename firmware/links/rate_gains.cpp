// What the rate of a link is made of: once for a rig.
#include "firmware/links/link_motion.hpp"

namespace firmware {

RateGains rate_gains(const CoreConfiguration& configuration, const LinkConfiguration& link) {
  RateGains gains;
  gains.has_a = link.node_a != kGroundNode;
  gains.has_b = link.node_b != kGroundNode;
  const int velocity_index = static_cast<int>(Quantity::kVelocity);
  gains.column_a = static_cast<uint16_t>(signal_column(gains.has_a ? link.node_a : 0, Quantity::kVelocity));
  gains.column_b = static_cast<uint16_t>(signal_column(gains.has_b ? link.node_b : 0, Quantity::kVelocity));
  const Scaled unit_a = gains.has_a ? configuration.signals[link.node_a][velocity_index].unit_per_code : Scaled{};
  const Scaled unit_b = gains.has_b ? configuration.signals[link.node_b][velocity_index].unit_per_code : Scaled{};
  const Scaled coarser = unit_a > unit_b ? unit_a : unit_b;
  if (coarser.is_zero()) return gains;
  gains.gain_a = RateGain::from_raw(static_cast<int32_t>(to_fixed(unit_a / coarser, RateGain::kFractionBits)));
  gains.gain_b = RateGain::from_raw(static_cast<int32_t>(to_fixed(unit_b / coarser, RateGain::kFractionBits)));
  return gains;
}

}  // namespace firmware
