#include "host_sim/data_check/flat/tops.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace host_sim::data_check {
namespace {

// Of the slope next to a run, what a smooth turn may have kept by that count: beside the top of a sine of w radians a sample w^2, a
// fifth with 14 samples a period. A parabola that is cut off keeps four fifths.
constexpr double kTurnsAnyway = 0.2;

// Slope at the very end of a run, towards its level, from the two spans before (side -1) or behind it (+1): what comes to rest
// or turns smoothly has shed its speed there, what is cut off has not, not even over the few samples in which it passes `seen`, what
// noise and steps let one see. Nothing where the record ends.
std::optional<double> slope_at_end(const std::vector<double>& values, const Run& run, double sign, int side,
                                   double seen) {
  const auto span = static_cast<std::ptrdiff_t>(std::max<size_t>(1, run.length / 4));
  const auto next = static_cast<std::ptrdiff_t>(side < 0 ? run.first - 1 : run.first + run.length);
  if (next + 2 * side * span < 0 || next + 2 * side * span >= static_cast<std::ptrdiff_t>(values.size())) return {};
  const auto at = [&](std::ptrdiff_t spans) { return values[static_cast<size_t>(next + side * span * spans)]; };
  const double width = static_cast<double>(span), near = sign * (at(0) - at(1)) / width,
               far = sign * (at(1) - at(2)) / width;
  if (near > 0.0 && seen < near * width) {
    const auto few = static_cast<std::ptrdiff_t>(std::max(1.0, std::ceil(seen / near)));
    const double nearest = sign * (at(0) - values[static_cast<size_t>(next + side * few)]) / static_cast<double>(few);
    if (nearest < kTurnsAnyway * near) return 0.0;
  }
  const double end = near - (far - near) * (0.5 + 0.5 * width) / width;
  return end < kTurnsAnyway * near ? 0.0 : end;
}

}  // namespace

std::vector<Run> runs_at(const std::vector<double>& values, double level, double band, double sign) {
  std::vector<Run> runs;
  for (size_t i = 0; i < values.size(); ++i) {
    const size_t first = i;
    while (i < values.size() && sign * (level - values[i]) <= band) ++i;
    if (i - first >= 2) runs.push_back({first, i - first});
  }
  return runs;
}

Tops tops_at(const std::vector<double>& values, const std::vector<Run>& runs, double sign, double seen) {
  Tops tops;
  tops.where = runs;
  for (const Run& run : runs) {
    ++tops.runs;
    tops.samples += run.length;
    tops.longest = std::max(tops.longest, run.length);
  }
  double counted = 0.0;
  for (const Run& run : runs) {
    const auto entered = slope_at_end(values, run, sign, -1, seen), left = slope_at_end(values, run, sign, 1, seen);
    const bool at_end = run.first == 0 || run.first + run.length == values.size();
    const bool sheds_speed = entered.value_or(1.0) <= 0.0 || left.value_or(1.0) <= 0.0;
    if (!at_end && !sheds_speed) tops.longest_cut = std::max(tops.longest_cut, run.length);
    if (2 * run.length < tops.longest || !entered || !left) continue;
    // a parabola that rises with that slope over half the run turns at a quarter of their product
    tops.missing += std::min(*entered, *left) * static_cast<double>(run.length) / 4.0, counted += 1.0;
  }
  if (counted > 0.0) tops.missing /= counted;
  return tops;
}

}  // namespace host_sim::data_check
