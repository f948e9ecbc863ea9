#include "host_sim/records/value_step.hpp"

#include <cmath>
#include <limits>

namespace host_sim {

double value_step(const std::vector<double>& values) {
  double smallest = std::numeric_limits<double>::infinity();
  for (size_t i = 1; i < values.size(); ++i) {
    const double step = std::abs(values[i] - values[i - 1]);
    if (step > 1e-12 * std::abs(values[i])) smallest = std::min(smallest, step);
  }
  if (!std::isfinite(smallest)) return 0.0;
  size_t steps = 0, whole = 0;
  double sum = 0.0, count = 0.0;
  for (size_t i = 1; i < values.size(); ++i) {
    const double multiple = std::abs(values[i] - values[i - 1]) / smallest, nearest = std::nearbyint(multiple);
    if (nearest < 1.0 || nearest > 50.0) continue;  // beyond, the smallest step's own rounding adds up
    ++steps;
    if (std::abs(multiple - nearest) < 0.01 * nearest + 0.01) {
      ++whole;
      sum += multiple;
      count += nearest;
    }
  }
  const bool quantised = steps >= 20 && static_cast<double>(whole) >= 0.99 * static_cast<double>(steps);
  return quantised ? smallest * sum / count : 0.0;
}

}  // namespace host_sim
