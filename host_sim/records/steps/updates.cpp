#include "host_sim/records/steps/updates.hpp"

#include <algorithm>
#include <cmath>

namespace host_sim {
namespace {

constexpr double kFinest = 0.05;  // of the steps are no larger: the finest where no resolution shows
constexpr double kFar = 4.0;      // times the finest
constexpr double kOfRange = 0.5;
constexpr double kHeld = 0.6;  // of the far steps: a lone value off its neighbours is two steps, one of which is held
constexpr size_t kFewest = 20;
constexpr double kRest = 8.0;  // times the usual run: not the sensor's hold but the motion's rest

// The size that so many of them do not exceed.
double size_at(std::vector<double> sizes, double share) {
  const auto place =
      sizes.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sizes.empty() ? 0 : sizes.size() - 1));
  std::nth_element(sizes.begin(), place, sizes.end());
  return *place;
}

// Between which sizes a step is far.
struct Far {
  double least = 0.0, most = 0.0;
};
Far far_steps(const std::vector<double>& values, const std::vector<double>& sizes, double resolution) {
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  return {kFar * std::max(resolution, size_at(sizes, kFinest)), kOfRange * (*highest - *lowest)};
}

// How many rows follow each far step at its value, that row included.
std::vector<double> runs_behind(const std::vector<double>& values, const Far& far) {
  std::vector<double> runs;
  for (size_t i = 1; i < values.size();) {
    size_t behind = i + 1;
    while (behind < values.size() && values[behind] == values[i]) ++behind;
    const double size = std::abs(values[i] - values[i - 1]);
    if (size >= far.least && size <= far.most) runs.push_back(static_cast<double>(behind - i));
    i = behind;
  }
  return runs;
}

}  // namespace

double rows_per_update(const std::vector<double>& values, double resolution) {
  std::vector<double> sizes;
  for (size_t i = 1; i < values.size(); ++i)
    if (values[i] != values[i - 1]) sizes.push_back(std::abs(values[i] - values[i - 1]));
  if (sizes.size() < kFewest || sizes.size() + kFewest / 2 > values.size()) return 1.0;
  const std::vector<double> runs = runs_behind(values, far_steps(values, sizes, resolution));
  const auto held = std::count_if(runs.begin(), runs.end(), [](double run) { return run > 1.0; });
  if (runs.size() < kFewest || static_cast<double>(held) < kHeld * static_cast<double>(runs.size())) return 1.0;
  const double longest = kRest * size_at(runs, 0.5);
  double rows = 0.0, updates = 0.0;
  for (const double run : runs)
    if (run <= longest) rows += run, updates += 1.0;
  return rows / updates;
}

}  // namespace host_sim
