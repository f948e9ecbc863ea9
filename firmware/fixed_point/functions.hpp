// Sine and exponential in fixed point, for force laws. Polynomials fitted at Chebyshev points; errors include the rounding.
#pragma once
#include <cstdint>

#include "firmware/fixed_point/fixed.hpp"
#include "firmware/fixed_point/in_place.hpp"

namespace firmware {

using Q30 = Fixed<int32_t, 30>;

// sin(2 pi turns / 2^32); error below 2e-8.
Q30 sine_of_turns(uint32_t turns);
// 2^-x for x >= 0; error below 2e-8. Above 31 the result is 0.
Q30 exp2_of_minus(Fixed<int64_t, 26> x);

}  // namespace firmware

#ifdef FIRMWARE_IN_PLACE
#include "firmware/fixed_point/exponential.hpp"
#endif
