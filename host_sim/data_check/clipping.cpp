#include "host_sim/data_check/clipping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace host_sim::data_check {
namespace {

constexpr double kChance = 1e-4;        // of one record to show this without a fault
constexpr size_t kFewestNoisyRuns = 6;  // slopes amid noise are means over that many
constexpr size_t kFewestRuns = 3;       // one or two flat tops may be anything
constexpr double kFaultShare = 0.002;   // of all samples; below it estimates suffer less than their intervals

struct Tops {
  size_t samples = 0, runs = 0, longest = 0;
  double slope = 0.0;    // mean of the last step before and the first behind the flat part, towards it
  double turning = 0.0;  // by how much that slope shrinks from step to step
  double missing = 0.0;  // height of the parabola through the run's ends
  double turn =
      0.0;  // height over the longest run of a parabola through the values that lie its length before and behind it
};

// Stretches of two and more samples within `band` of the level. sign +1: the level is the highest value; -1: the lowest.
std::vector<Run> runs_at(const std::vector<double>& values, double level, double band, double sign) {
  std::vector<Run> runs;
  for (size_t i = 0; i < values.size(); ++i) {
    const size_t first = i;
    while (i < values.size() && sign * (level - values[i]) <= band) ++i;
    if (i - first >= 2) runs.push_back({first, i - first});
  }
  return runs;
}

// A parabola that is L samples wide at its level is 8 times as far below it another L to either side as its top is above it.
double turn_over(const std::vector<double>& values, const Run& run, double sign) {
  double fall = 0.0, sides = 0.0;
  const double level = values[run.first];
  if (run.first >= run.length) fall += sign * (level - values[run.first - run.length]), sides += 1.0;
  const size_t behind = run.first + 2 * run.length - 1;
  if (behind < values.size()) fall += sign * (level - values[behind]), sides += 1.0;
  return sides > 0.0 ? fall / sides / 8.0 : 0.0;
}

Tops tops_at(const std::vector<double>& values, const std::vector<Run>& runs, double sign) {
  Tops tops;
  double steps[3] = {};
  double sides = 0.0;
  for (const Run& run : runs) {
    ++tops.runs;
    tops.samples += run.length;
    if (run.length > tops.longest) tops.longest = run.length, tops.turn = turn_over(values, run, sign);
    const size_t behind = run.first + run.length;
    if (run.first >= 4) {
      for (size_t k = 0; k < 3; ++k) steps[k] += sign * (values[run.first - k - 1] - values[run.first - k - 2]);
      sides += 1.0;
    }
    if (behind + 4 < values.size()) {
      for (size_t k = 0; k < 3; ++k) steps[k] += sign * (values[behind + k] - values[behind + k + 1]);
      sides += 1.0;
    }
  }
  if (sides == 0.0) return tops;
  tops.slope = steps[0] / sides;
  tops.turning = 0.5 * (steps[2] - steps[0]) / sides;
  tops.missing = tops.slope * static_cast<double>(tops.samples) / static_cast<double>(tops.runs) / 4.0;
  return tops;
}

// Runs of L equal values at the very end of the range: expected number of chance is N p^(L-1). Where a step of the converter is
// more than the noise, a smooth turn stays on its last step for as long as it is within it, and a stop in friction longer.
bool beyond_chance(const Tops& tops, const Statistics& statistics, size_t count) {
  if (!statistics.noisy || tops.longest < 4) return false;
  if (statistics.resolution > statistics.noise && (tops.runs < kFewestRuns || tops.turn < 1.5 * statistics.resolution))
    return false;
  const double p = std::clamp(statistics.repeats, 1e-3, 1.0);
  return static_cast<double>(count) * std::pow(p, static_cast<double>(tops.longest - 1)) < kChance;
}

// A stop has shed its speed when it comes to rest: its last step is at most twice by what steps shrink. A smooth turn
// is no higher than the band that it is looked at in.
bool cut_off(const Tops& tops, const Statistics& statistics, double band) {
  if (tops.runs < kFewestRuns || !(tops.slope > 0.0)) return false;
  return tops.slope > 4.0 * std::max(0.0, tops.turning) &&
         tops.missing > std::max(1.5 * band, 3.0 * std::max(statistics.resolution, statistics.noise));
}

// Ramps and squares, as commanded signals are: most second differences inside the range vanish.
bool piecewise_straight(const std::vector<double>& values, const Statistics& statistics) {
  size_t inside = 0, straight = 0;
  for (size_t i = 1; i + 1 < values.size(); ++i) {
    if (values[i] == statistics.highest || values[i] == statistics.lowest) continue;
    ++inside;
    if (std::abs(values[i + 1] - 2.0 * values[i] + values[i - 1]) <= 1e-6 * statistics.range) ++straight;
  }
  return inside < 20 || 2 * straight > inside;
}

std::string said(const Tops& top, const Tops& bottom, size_t count, const Statistics& statistics) {
  const bool high = top.samples > 0, low = bottom.samples > 0;
  const double share = 100.0 * static_cast<double>(top.samples + bottom.samples) / static_cast<double>(count);
  const std::string where = high && low ? fmt::format("{:.4g} and {:.4g}", statistics.lowest, statistics.highest)
                                        : fmt::format("{:.4g}", high ? statistics.highest : statistics.lowest);
  return fmt::format(
      "flat at {} for {:.2g} % of the samples ({} times): its range ends there; lower the level or widen the range, "
      "then "
      "record again",
      where, share, top.runs + bottom.runs);
}

}  // namespace

std::optional<Finding> find_clipping(const Channel& channel, const Statistics& statistics, double lower_limit,
                                     double upper_limit) {
  const std::vector<double>& values = channel.values;
  if (statistics.lowest == statistics.highest) return std::nullopt;
  // What saturates in front of the noise (an amplifier) is flat within the noise: three deviations to each side.
  const double band = statistics.noisy ? 6.0 * statistics.noise : 0.0;
  Tops top = tops_at(values, runs_at(values, statistics.highest, 0.0, 1.0), 1.0),
       bottom = tops_at(values, runs_at(values, statistics.lowest, 0.0, -1.0), -1.0);
  const bool at_limit_high = upper_limit > lower_limit && statistics.highest >= upper_limit && top.samples > 1;
  const bool at_limit_low = upper_limit > lower_limit && statistics.lowest <= lower_limit && bottom.samples > 1;
  const bool curved = !piecewise_straight(values, statistics);
  const bool noisy = beyond_chance(top, statistics, values.size()) || beyond_chance(bottom, statistics, values.size());
  const auto judge = [&](Tops& tops, bool at_limit, double level, double sign) {
    if (at_limit || beyond_chance(tops, statistics, values.size())) return;
    if (curved && cut_off(tops, statistics, 0.0)) return;
    tops = band > 0.0 && channel.quantity != Quantity::kForce
               ? tops_at(values, runs_at(values, level, band, sign), sign)
               : Tops();
    const double share = static_cast<double>(tops.samples) / static_cast<double>(values.size());
    const bool often = share > kFaultShare && share < 0.5;
    if (tops.runs < kFewestNoisyRuns || !often || !cut_off(tops, statistics, band)) tops = Tops();
  };
  judge(top, at_limit_high, statistics.highest, 1.0);
  judge(bottom, at_limit_low, statistics.lowest, -1.0);
  if (top.samples + bottom.samples == 0) return std::nullopt;
  const double share = static_cast<double>(top.samples + bottom.samples) / static_cast<double>(values.size());
  Finding finding;
  finding.kind = "clipped";
  finding.channel = channel.name;
  finding.value = share;
  finding.detail = said(top, bottom, values.size(), statistics);
  // A smooth force that is cut may be the drive's own limit, truly measured.
  const bool perhaps_drive = channel.quantity == Quantity::kForce && !noisy && !at_limit_high && !at_limit_low;
  finding.weight = share >= kFaultShare && !perhaps_drive ? Weight::kFault : Weight::kDoubt;
  if (perhaps_drive) finding.detail += " (if the drive itself ends there and this is what acts, nothing is wrong)";
  return finding;
}

}  // namespace host_sim::data_check
