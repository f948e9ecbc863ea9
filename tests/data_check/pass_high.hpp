// A high-pass of first order, by another rule than the product undoes it with.
#pragma once
#include <vector>

namespace made {

// y' = x' - wc y by the trapezoid: jw / (jw + wc) with an error of (wT)^2 / 12 of wc / w.
inline void pass_high(std::vector<double>& values, double corner_Hz, double step_s) {
  const double half = 0.5 * 6.283185307179586 * corner_Hz * step_s;
  double before = values.front(), y = 0.0;
  for (double& value : values) {
    y = ((1.0 - half) * y + value - before) / (1.0 + half);
    before = value, value = y;
  }
}

}  // namespace made
