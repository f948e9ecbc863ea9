// Between the core's block-floating numbers and double, for programs with an operating system.
#pragma once
#include "firmware/fixed_point/scaled.hpp"

namespace rig_file {

firmware::Scaled to_scaled(double value);  // exact; value must be finite
double to_double(firmware::Scaled value);  // rounded to 53 bits

}  // namespace rig_file
