// The drive command and the limits that hold for it.
#pragma once
#include <cstdint>

#include "firmware/fixed_point/fixed.hpp"

namespace firmware {

// Signed fraction of the shaker amplifier's full scale, -1 <= drive < 1.
using Drive = Fixed<int32_t, 31>;

struct DriveLimits {
  Drive magnitude = Drive::from_raw(INT32_MAX);  // |drive| never exceeds this
  Drive step_per_sample =
      Drive::from_raw(INT32_MAX);  // |change| from one sample to the next, except towards zero in an abort or a release
};

constexpr int32_t clamp_magnitude(int64_t value, int32_t limit) {
  return static_cast<int32_t>(value > limit ? limit : (value < -static_cast<int64_t>(limit) ? -limit : value));
}

}  // namespace firmware
