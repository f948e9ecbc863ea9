// What the axes of a picture have to show.
#pragma once
#include "host_sim/reports/figures/plot.hpp"

namespace host_sim::reports {

// Of what is finite.
struct Range {
  double low = 0.0, high = 0.0;
  bool any = false;
  void add(double value);
  double size() const;  // of the largest magnitude
};

Range x_range(const Plot& plot);
// Of a logarithmic plot the first curve, which is what was measured: nobody asks for what lies far below it.
Range y_range(const Plot& plot);

}  // namespace host_sim::reports
