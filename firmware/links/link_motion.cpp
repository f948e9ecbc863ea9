#include "firmware/links/link_motion.hpp"

namespace firmware {
namespace {

// 20 times the smoothed velocity fits 32 bits: 20 * 2^23 < 2^28.
Code smooth(ConstColumn<Code> v, int i) { return 10 * v[i] + 4 * (v[i - 2] + v[i + 2]) + v[i - 1] + v[i + 1]; }
Code velocity(ConstColumn<Code> v, bool smoothed, int i) { return smoothed ? smooth(v, i) : v[i]; }

}  // namespace

bool equal_units(const RateGains& gains) { return !gains.has_a || !gains.has_b || gains.gain_a == gains.gain_b; }

void rate_of_difference(const RateGains& gains, const Frame& frame, int from, int to, Code* rate) {
  const ConstColumn<Code> a = frame.codes(gains.column_a), b = frame.codes(gains.column_b);
  if (!gains.has_b) {
    for (int i = from; i < to; ++i) rate[i] = a[i];
  } else if (!gains.has_a) {
    for (int i = from; i < to; ++i) rate[i] = -b[i];
  } else {
    for (int i = from; i < to; ++i) rate[i] = a[i] - b[i];
  }
}

void signs_of_difference(const RateGains& gains, const Frame& frame, bool smoothed, int from, int to,
                         Column<Code> sign) {
  if (!smoothed) {
    Code rate[kFrameStride];
    rate_of_difference(gains, frame, from, to, rate);
    for (int i = from; i < to; ++i) sign.put(i, Code::from_raw(sign_of(rate[i])));
    return;
  }
  const ConstColumn<Code> a = frame.codes(gains.column_a), b = frame.codes(gains.column_b);
  for (int i = from; i < to; ++i) {
    const Code left = gains.has_a ? smooth(a, i) : Code{}, right = gains.has_b ? smooth(b, i) : Code{};
    sign.put(i, Code::from_raw(static_cast<int32_t>(right < left) - static_cast<int32_t>(left < right)));
  }
}

void link_rate(const RateGains& gains, const Frame& frame, bool smoothed, int from, int to, Rate* rate) {
  for (int i = from; i < to; ++i) {
    Fixed<int64_t, 28> w;
    if (gains.has_a) w = w + velocity(frame.codes(gains.column_a), smoothed, i) * gains.gain_a;
    if (gains.has_b) w = w - velocity(frame.codes(gains.column_b), smoothed, i) * gains.gain_b;
    rate[i] = rescale<Rate>(w);
  }
}

void signs(const Rate* rate, int from, int to, Column<Code> sign) {
  for (int i = from; i < to; ++i) sign.put(i, Code::from_raw(sign_of(rate[i])));
}

}  // namespace firmware
