// The scale of a picture's axis: its range, its ticks, and where a value lies on it.
#pragma once
#include <string>
#include <vector>

namespace host_sim::reports {

struct Tick {
  double value;
  std::string label;  // as SVG text; two ticks of an axis never read the same
};

struct Axis {
  double low = 0.0, high = 1.0;  // low < high
  bool log = false;
  double at_low = 0.0, at_high = 1.0;  // coordinates of the picture
  std::vector<Tick> ticks;
  double place(double value) const;
};

// Round steps of 1, 2 or 5 times a power of ten, `wanted` ticks or a few less; labels with as many digits as set them
// apart, in powers of ten beyond five digits.
Axis linear_axis(double low, double high, int wanted);
// Whole decades from low > 0 to high, at most `wanted` of them labelled.
Axis decade_axis(double low, double high, int wanted);

}  // namespace host_sim::reports
