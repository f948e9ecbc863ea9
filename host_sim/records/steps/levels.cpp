#include "host_sim/records/steps/levels.hpp"

#include <algorithm>
#include <cmath>

namespace host_sim {
namespace {

constexpr double kMost = 0.95, kOff = 0.02;  // of the values; of the unit
constexpr double kFew = 50.0;                // to either side: beyond, the error of the unit adds up to a level

// The value that is held most often.
double usual_level(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  double level = values.front();
  size_t most = 0;
  for (size_t first = 0, behind = 0; first < values.size(); first = behind) {
    while (behind < values.size() && values[behind] == values[first]) ++behind;
    if (behind - first > most) most = behind - first, level = values[first];
  }
  return level;
}

}  // namespace

bool on_few_levels(const std::vector<double>& values, double unit) {
  if (values.empty()) return false;
  const double level = usual_level(values);
  const auto on = std::count_if(values.begin(), values.end(), [&](double value) {
    const double multiple = (value - level) / unit;
    return std::abs(multiple) < kFew && std::abs(multiple - std::nearbyint(multiple)) < kOff;
  });
  return static_cast<double>(on) >= kMost * static_cast<double>(values.size());
}

}  // namespace host_sim
