// How wide an interval is.
#pragma once

namespace diagnosis {

// Of a 95 % interval half, in standard deviations: the normal distribution's 97.5 % point.
constexpr double kHalfOf95 = 1.96;

}  // namespace diagnosis
