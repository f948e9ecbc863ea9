#include "host_sim/programs/results/level_ratio.hpp"

#include <algorithm>
#include <cmath>

#include "hal/rig_file/rig_model.hpp"

namespace host_sim {
namespace {

// Variances of the channels that the rule takes, added up.
template <typename Rule>
double power(const Record& record, Rule rule) {
  double sum = 0.0;
  for (const Channel& channel : record.channels) {
    if (!rule(channel) || channel.values.empty()) continue;
    const auto n = static_cast<double>(channel.values.size());
    double mean = 0.0;
    for (const double value : channel.values) mean += value / n;
    for (const double value : channel.values) sum += (value - mean) * (value - mean) / n;
  }
  return sum;
}

double level_of(const Record& record) {
  const double force = power(record, [](const Channel& c) { return c.quantity == Quantity::kForce; });
  if (force > 0.0) return std::sqrt(force);
  const double base = power(record, [](const Channel& c) { return c.dof == rig_file::kBase; });
  if (base > 0.0) return std::sqrt(base);
  return std::sqrt(power(record, [](const Channel&) { return true; }));
}

}  // namespace

double level_ratio(const std::vector<Record>& records) {
  double low = 0.0, high = 0.0;
  for (const Record& record : records) {
    const double level = level_of(record);
    if (!(level > 0.0)) continue;
    low = low == 0.0 ? level : std::min(low, level);
    high = std::max(high, level);
  }
  return low > 0.0 ? high / low : 1.0;
}

}  // namespace host_sim
