#include "firmware/links/link_motion.hpp"

namespace firmware {
namespace {

constexpr int kGainFraction = 23;

int64_t velocity(const Frame& frame, int column, bool smoothed, int i) {
  const int32_t* v = &frame.column[column][i];
  if (!smoothed) return v[0];
  return 10 * static_cast<int64_t>(v[0]) + 4 * (static_cast<int64_t>(v[-2]) + v[2]) + v[-1] + v[1];
}

// 20 times the smoothed velocity fits 32 bits: 20 * 2^23 < 2^28.
int32_t velocity_sum(const int32_t* v, bool smoothed) {
  return smoothed ? 10 * v[0] + 4 * (v[-2] + v[2]) + v[-1] + v[1] : v[0];
}

}  // namespace

bool equal_units(const RateGains& gains) { return !gains.has_a || !gains.has_b || gains.gain_a == gains.gain_b; }

void rate_of_difference(const RateGains& gains, const Frame& frame, int from, int to, int32_t* rate) {
  const int32_t* a = frame.column[gains.column_a];
  const int32_t* b = frame.column[gains.column_b];
  if (!gains.has_b) {
    for (int i = from; i < to; ++i) rate[i] = a[i];
  } else if (!gains.has_a) {
    for (int i = from; i < to; ++i) rate[i] = -b[i];
  } else {
    for (int i = from; i < to; ++i) rate[i] = a[i] - b[i];
  }
}

void signs_of_difference(const RateGains& gains, const Frame& frame, bool smoothed, int from, int to, int32_t* sign) {
  static const int32_t kRest[kFrameStride] = {};
  const int32_t* a = gains.has_a ? frame.column[gains.column_a] : kRest;
  const int32_t* b = gains.has_b ? frame.column[gains.column_b] : kRest;
  for (int i = from; i < to; ++i) {
    const int32_t left = velocity_sum(a + i, smoothed), right = velocity_sum(b + i, smoothed);
    sign[i] = static_cast<int32_t>(left > right) - static_cast<int32_t>(left < right);
  }
}

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
  gains.gain_a = static_cast<int32_t>(to_fixed(unit_a / coarser, kGainFraction + kRateGuardBits));
  gains.gain_b = static_cast<int32_t>(to_fixed(unit_b / coarser, kGainFraction + kRateGuardBits));
  return gains;
}

void link_rate(const RateGains& gains, const Frame& frame, bool smoothed, int from, int to, int64_t* rate) {
  for (int i = from; i < to; ++i) {
    int64_t w = 0;
    if (gains.has_a) w += velocity(frame, gains.column_a, smoothed, i) * gains.gain_a;
    if (gains.has_b) w -= velocity(frame, gains.column_b, smoothed, i) * gains.gain_b;
    rate[i] = (w + (int64_t{1} << (kGainFraction - 1))) >> kGainFraction;
  }
}

void signs(const int64_t* rate, int from, int to, int32_t* sign) {
  for (int i = from; i < to; ++i) sign[i] = static_cast<int32_t>(rate[i] > 0) - static_cast<int32_t>(rate[i] < 0);
}

}  // namespace firmware
