#include "hal/rig_file/scaled_double.hpp"

#include <cmath>

namespace rig_file {

firmware::Scaled to_scaled(double value) {
  firmware::Scaled result;
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);  // 0.5 <= |fraction| < 1, or 0
  result.mantissa = static_cast<int64_t>(std::ldexp(fraction, 62));
  result.exponent = result.mantissa == 0 ? 0 : exponent - 62;
  return result;
}

double to_double(firmware::Scaled value) { return std::ldexp(static_cast<double>(value.mantissa), value.exponent); }

}  // namespace rig_file
