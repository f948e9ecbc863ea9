// Shapes in the middle of the ranges that the rows name, so that tests can walk over effects they do not know.
#pragma once
#include <cmath>

#include "host_sim/vocabulary/law.hpp"

namespace vocabulary_test {

struct Scales {
  double u_peak, u_rms, w_rms, duration_s, sampling_rate_Hz, force_peak;
};

inline double scale_of(firmware::RangeOf of, const Scales& s, double first_shape) {
  switch (of) {
    case firmware::RangeOf::kElongationPeak:
      return s.u_peak;
    case firmware::RangeOf::kElongationRms:
      return s.u_rms;
    case firmware::RangeOf::kRateRms:
      return s.w_rms;
    case firmware::RangeOf::kSlideTime:
      return first_shape / s.w_rms;
    case firmware::RangeOf::kDuration:
      return s.duration_s;
    case firmware::RangeOf::kSamplingRate:
      return s.sampling_rate_Hz;
    case firmware::RangeOf::kForcePeak:
      return s.force_peak;
    case firmware::RangeOf::kOne:
      break;
  }
  return 1.0;
}

// The geometric middle of a range (a third of its top where it starts at 0). core_only: without shapes beyond the core.
inline vocabulary::Shape typical_shape(const firmware::EffectRow& row, const Scales& scales, bool core_only = true) {
  vocabulary::Shape shape;
  for (int i = 0; i < row.shape.count; ++i) {
    const firmware::ShapeParameter& p = row.shape.at[i];
    if (core_only && !p.in_core) continue;
    const double low = 1e-6 * p.range.low_millionths, high = 1e-6 * p.range.high_millionths;
    shape.p[i] = (low > 0 ? std::sqrt(low * high) : high / 3) * scale_of(p.range.of, scales, shape.p[0]);
  }
  return shape;
}

}  // namespace vocabulary_test
