// Student's t: half width of the central 95 % interval in standard deviations.
#pragma once
#include "firmware/fixed_point/scaled.hpp"

namespace firmware {

// freedom > 0, need not be whole. Table to 5, above it the expansion in 1 / freedom (Abramowitz and Stegun 26.7.5) to
// the third power: error below 2e-4. Below 1 the value at 1 is returned.
Scaled student_quantile_95(const Scaled& freedom);

}  // namespace firmware
