#include "host_sim/reports/figures/range.hpp"

#include <algorithm>
#include <cmath>

namespace host_sim::reports {

void Range::add(double value) {
  if (!std::isfinite(value)) return;
  low = any ? std::min(low, value) : value;
  high = any ? std::max(high, value) : value;
  any = true;
}

double Range::size() const { return std::max(std::abs(low), std::abs(high)); }

Range y_range(const Plot& plot) {
  Range range;
  if (plot.y_low <= plot.y_high) return range.add(plot.y_low), range.add(plot.y_high), range;
  if (plot.map.columns > 0) range.add(plot.map.y_low), range.add(plot.map.y_high);
  for (const Curve& curve : plot.curves) {
    for (const std::vector<double>* values : {&curve.y, &curve.y_high})
      for (double value : *values)
        if (!plot.log_y || value > 0.0) range.add(value);
    if (plot.log_y && range.any) break;
  }
  return range;
}

Range x_range(const Plot& plot) {
  Range range;
  if (plot.map.columns > 0) range.add(plot.map.x_low), range.add(plot.map.x_high);
  for (const Curve& curve : plot.curves)
    for (double value : curve.x) range.add(value);
  return range;
}

}  // namespace host_sim::reports
