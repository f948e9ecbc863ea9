#include "host_sim/data_check/flat/clipping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host_sim/data_check/flat/plateau.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kChance = 1e-4;        // of one record to show this without a fault
constexpr size_t kFewestNoisyRuns = 6;  // slopes amid noise are means over that many
constexpr size_t kFewestRuns = 3;       // one or two flat tops may be anything
// Of the slope next to a run, what a smooth turn may have kept by that count: beside the top of a sine of w radians a sample w^2, a
// fifth with 14 samples a period. A parabola that is cut off keeps four fifths.
constexpr double kTurnsAnyway = 0.2;
constexpr double kStepsSeen = 4.0;     // of resolution or deviations of noise: a slope over so many is known to a third
constexpr size_t kFewestFlat = 3;      // samples: of fewer any sine's top is made that is symmetric to them
constexpr double kFaultShare = 0.002;  // of all samples; below it estimates suffer less than their intervals

struct Tops {
  size_t samples = 0, runs = 0, longest = 0;
  // Of those within the record that are entered or left with some speed: a rig that rests sheds it before, and one that is still to be
  // driven, or has been, rests at the record's ends.
  size_t longest_cut = 0;
  double missing =
      0.0;  // mean height that is cut off the longer runs, by the slopes with which they are entered and left
  std::vector<Run> where;
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

// What is cut off at both ends of the range.
struct FlatTops {
  Tops top, bottom;
  bool amid_noise = false, at_limit = false;
};

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

// record: what stands beside the channel; may be missing.
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

}  // namespace

std::vector<Run> clipped_runs(const Channel& channel, const Record& record) {
  FlatTops tops = flat_tops(channel, &record, statistics_of(channel), 0.0, 0.0);
  std::vector<Run> runs = std::move(tops.top.where);
  runs.insert(runs.end(), tops.bottom.where.begin(), tops.bottom.where.end());
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.first < b.first; });
  return runs;
}

std::optional<Finding> find_clipping(const Channel& channel, const Statistics& statistics, double lower_limit,
                                     double upper_limit, const Record* record) {
  const std::vector<double>& values = channel.values;
  const FlatTops tops = flat_tops(channel, record, statistics, lower_limit, upper_limit);
  const Tops &top = tops.top, &bottom = tops.bottom;
  if (top.samples + bottom.samples == 0) return std::nullopt;
  const double share = static_cast<double>(top.samples + bottom.samples) / static_cast<double>(values.size());
  Finding finding;
  finding.kind = "clipped";
  finding.channel = channel.name;
  finding.value = share;
  finding.detail = said(top, bottom, values.size(), statistics);
  // A smooth force that is cut may be the drive's own limit, truly measured.
  const bool perhaps_drive = channel.quantity == Quantity::kForce && !tops.amid_noise && !tops.at_limit;
  finding.weight = share >= kFaultShare && !perhaps_drive ? Weight::kFault : Weight::kDoubt;
  if (perhaps_drive) finding.detail += " (if the drive itself ends there and this is what acts, nothing is wrong)";
  return finding;
}

}  // namespace host_sim::data_check
