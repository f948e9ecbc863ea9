#include "host_sim/data_check/flat/flat_tops.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/data_check/flat/plateau.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kChance = 1e-4;        // of one record to show this without a fault
constexpr size_t kFewestNoisyRuns = 6;  // slopes amid noise are means over that many
constexpr size_t kFewestRuns = 3;       // one or two flat tops may be anything
constexpr double kStepsSeen = 4.0;  // of resolution or deviations of noise: a slope over so many is known to a third
constexpr size_t kFewestFlat = 3;   // samples: of fewer any sine's top is made that is symmetric to them

// Runs of L equal values at the very end of the range: expected number of chance is N p^(L-1). Where a step of the converter is
// more than the noise, a smooth turn stays on its last step for as long as it is within it, and a stop in friction longer.
bool beyond_chance(const Tops& tops, const Statistics& statistics, size_t count) {
  if (!statistics.noisy || tops.longest_cut < 4) return false;
  if (statistics.resolution > statistics.noise &&
      (tops.runs < kFewestRuns || tops.missing < 1.5 * statistics.resolution))
    return false;
  const double p = std::clamp(statistics.repeats, 1e-3, 1.0);
  return static_cast<double>(count) * std::pow(p, static_cast<double>(tops.longest_cut - 1)) < kChance;
}

// A smooth turn is no higher than the band that it is looked at in; in a band of noise, two samples are no flat stretch.
bool cut_off(const Tops& tops, const Statistics& statistics, double band) {
  if (tops.runs < kFewestRuns || tops.longest < kFewestFlat || (band > 0.0 && tops.samples < 3 * tops.runs))
    return false;
  return tops.missing > std::max(1.5 * band, 3.0 * std::max(statistics.resolution, statistics.noise));
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

// A velocity or an acceleration whose highest or lowest values are its noise about zero: it rests there.
bool rests(const Channel& channel, double level, double band, double sign) {
  const bool has_zero = channel.quantity == Quantity::kVelocity || channel.quantity == Quantity::kAcceleration;
  return has_zero && sign * level <= band;
}

// Tops that are flat within the noise, and are neither rest nor a motion that is held.
Tops tops_amid_noise(const Channel& channel, const Record* record, double level, double band, double sign,
                     double seen) {
  if (rests(channel, level, band, sign)) return {};
  const auto long_enough = [&](const Tops& tops) {
    const double share = static_cast<double>(tops.samples) / static_cast<double>(channel.values.size());
    return tops.runs >= kFewestNoisyRuns && share > kFaultShare && share < 0.5;
  };
  std::vector<Run> runs = runs_at(channel.values, level, band, sign);
  Tops tops = tops_at(channel.values, runs, sign, seen);
  if (record == nullptr || !long_enough(tops)) return long_enough(tops) ? tops : Tops();
  const Witnesses witnesses(*record, channel);
  runs.erase(std::remove_if(runs.begin(), runs.end(), [&](const Run& run) { return witnesses.hold(run, band); }),
             runs.end());
  tops = tops_at(channel.values, runs, sign, seen);
  return long_enough(tops) ? tops : Tops();
}

}  // namespace

FlatTops flat_tops(const Channel& channel, const Record* record, const Statistics& statistics, double lower_limit,
                   double upper_limit) {
  const std::vector<double>& values = channel.values;
  if (statistics.lowest == statistics.highest) return {};
  // What saturates in front of the noise (an amplifier) is flat within the noise: three deviations to each side.
  // Not where the converter's step makes the noise: a speed that is held looks so, by turns on either side of a step.
  const double band = statistics.noisy && statistics.noise > statistics.resolution ? 6.0 * statistics.noise : 0.0;
  const double seen = kStepsSeen * std::max(statistics.resolution, statistics.noise);
  Tops top = tops_at(values, runs_at(values, statistics.highest, 0.0, 1.0), 1.0, seen),
       bottom = tops_at(values, runs_at(values, statistics.lowest, 0.0, -1.0), -1.0, seen);
  const bool at_limit_high = upper_limit > lower_limit && statistics.highest >= upper_limit && top.samples > 1;
  const bool at_limit_low = upper_limit > lower_limit && statistics.lowest <= lower_limit && bottom.samples > 1;
  const bool noisy = beyond_chance(top, statistics, values.size()) || beyond_chance(bottom, statistics, values.size());
  const auto judge = [&](Tops& tops, bool at_limit, double level, double sign) {
    if (at_limit || beyond_chance(tops, statistics, values.size())) return;
    if (cut_off(tops, statistics, 0.0) && !piecewise_straight(values, statistics)) return;
    tops = band > 0.0 && channel.quantity != Quantity::kForce
               ? tops_amid_noise(channel, record, level, band, sign, seen)
               : Tops();
    if (!cut_off(tops, statistics, band)) tops = Tops();
  };
  judge(top, at_limit_high, statistics.highest, 1.0);
  judge(bottom, at_limit_low, statistics.lowest, -1.0);
  return {std::move(top), std::move(bottom), noisy, at_limit_high || at_limit_low};
}

}  // namespace host_sim::data_check
