#include "host_sim/data_check/spikes/spikes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host_sim/data_check/measures/quantile.hpp"
#include "host_sim/data_check/spikes/answered.hpp"
#include "host_sim/data_check/spikes/carried.hpp"
#include "host_sim/data_check/spikes/gaps.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kBeyondAccelerometers = 1e3, kBeyondForceSensors = 1e6;  // times the range of everything else
constexpr double kLoneAcceleration =
    1.5;                               // times what 90 % of the samples span: a contact lasts longer than one sample
constexpr double kBeyondMotion = 5.0;  // times what the velocity spans; an impact turns it round: 1
constexpr double kHarm = 1.02;
constexpr double kHammer = 0.1;             // of a force's rms, without its blows
constexpr double kHalf = 0.5, kSure = 4.0;  // of the momentum, deviations: once in 30,000 records
constexpr double kWorthSaying = 0.1;        // of the range, where no harm is done

std::vector<double> repaired(std::vector<double> x, const std::vector<Gap>& gaps) {
  for (const Gap& gap : gaps) {
    const size_t end = gap.first + gap.width;
    const double behind = x[end < x.size() ? end : gap.first - 1], before = gap.first > 0 ? x[gap.first - 1] : behind;
    for (size_t k = 0; k < gap.width; ++k)
      x[gap.first + k] = before + (behind - before) * static_cast<double>(k + 1) / static_cast<double>(gap.width + 1);
  }
  return x;
}

// Mean square of the channel, or of its derivative of that order over five samples: about the band of the estimation.
double mean_square(const std::vector<double>& x, int order) {
  constexpr size_t kSpan = 5;
  double sum = 0.0, count = 0.0, mean = 0.0;
  for (const double value : x) mean += value / static_cast<double>(x.size());
  for (size_t i = kSpan; i + kSpan < x.size(); ++i, count += 1.0) {
    const double value = order == 0   ? x[i] - mean
                         : order == 1 ? x[i + kSpan] - x[i - kSpan]
                                      : x[i + kSpan] - 2.0 * x[i] + x[i - kSpan];
    sum += value * value;
  }
  return count > 0.0 ? sum / count : 0.0;
}

// Does a force strike at that sample, or one of its neighbours?
bool struck(const std::vector<KnownChannel>& forces, size_t sample) {
  for (const KnownChannel& force : forces) {
    const std::vector<double>& values = force.channel->values;
    for (size_t i = sample > 2 ? sample - 2 : 0; i < std::min(sample + 3, values.size()); ++i)
      if (std::abs(values[i] - force.statistics->mean) > 3.0 * force.statistics->rms) return true;
  }
  return false;
}

std::vector<Gap> not_struck(std::vector<Gap> gaps, const std::vector<KnownChannel>& forces) {
  gaps.erase(std::remove_if(gaps.begin(), gaps.end(), [&](const Gap& gap) { return struck(forces, gap.first); }),
             gaps.end());
  return gaps;
}

// Of an acceleration or a force: no blow is like that. usual: between the 5 and 95 percent quantiles.
bool impossible(const Gap& gap, Quantity quantity, double usual, const Statistics& statistics,
                const Neighbours& neighbours) {
  if (quantity == Quantity::kAcceleration && gap.width == 1 && gap.size > kLoneAcceleration * usual &&
      !struck(neighbours.forces, gap.first))
    return true;
  const double beyond = quantity == Quantity::kForce ? kBeyondForceSensors : kBeyondAccelerometers;
  if (statistics.range > 0.0 && gap.size > beyond * statistics.range) return true;
  const double change = gap.size * static_cast<double>(gap.width) * neighbours.velocity_step;
  return neighbours.velocity_range > 0.0 && change > kBeyondMotion * neighbours.velocity_range;
}

// Blows of a force that its DOF's motion does not show.
bool none_acted(const Channel& channel, const std::vector<Gap>& blows, const Neighbours& neighbours) {
  if (channel.quantity != Quantity::kForce || blows.empty()) return false;
  // of a hammer nothing is left without its blows
  if (mean_square(repaired(channel.values, blows), 0) < kHammer * kHammer * mean_square(channel.values, 0))
    return false;
  const Answered motion = answered(neighbours.record, channel, blows, neighbours.velocity_step);
  return motion.std > 0.0 && motion.share + kSure * motion.std < kHalf;
}

}  // namespace

std::optional<Finding> find_spikes(const Channel& channel, const Statistics& statistics, const Neighbours& neighbours) {
  const std::vector<double>& x = channel.values;
  std::vector<Gap> gaps = spikes_in(x, statistics);
  const bool continuous = channel.quantity == Quantity::kDisplacement || channel.quantity == Quantity::kVelocity;
  size_t dropouts = 0;
  bool unanswered = false;
  if (continuous) {
    const std::vector<Gap> more = dropouts_in(x, statistics), ends = ends_off(x);
    dropouts = more.size();
    gaps.insert(gaps.end(), more.begin(), more.end());
    gaps.insert(gaps.end(), ends.begin(), ends.end());
  } else {
    const auto [low, high] = quantiles(x, 0.05, 0.95);
    const double usual = high - low;
    const auto possible = [&](const Gap& gap) {
      return !impossible(gap, channel.quantity, usual, statistics, neighbours);
    };
    unanswered = none_acted(channel, gaps, neighbours);
    if (!unanswered) gaps.erase(std::remove_if(gaps.begin(), gaps.end(), possible), gaps.end());
  }
  if (gaps.empty()) return std::nullopt;
  const auto largest =
      std::max_element(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) { return a.size < b.size; });
  const std::vector<double> without = repaired(x, gaps);
  double harm = 1.0;
  for (int order = 0; order <= neighbours.differentiated; ++order)
    if (const double clean = mean_square(without, order); clean > 0.0)
      harm = std::max(harm, mean_square(x, order) / clean);
  Carried also;
  if (continuous) also = carried(neighbours.record, channel, not_struck(gaps, neighbours.forces));
  const bool told_there = also.harm > std::max(harm, kHarm);
  harm = std::max(harm, also.harm);
  if (harm <= kHarm && largest->size < kWorthSaying * statistics.range) return std::nullopt;
  const auto [lowest, highest] = std::minmax_element(without.begin(), without.end());
  std::string text = fmt::format("{} {}; the largest at {} is {:.3g}, where the rest spans {:.3g}", gaps.size(),
                                 dropouts == gaps.size() ? (dropouts == 1 ? "dropout" : "dropouts")
                                 : gaps.size() == 1      ? "spike"
                                                         : "spikes",
                                 said_sample(neighbours.record, largest->first), x[largest->first], *highest - *lowest);
  Finding finding;
  finding.kind = "spikes";
  finding.channel = channel.name;
  finding.value = static_cast<double>(gaps.size());
  finding.weight = harm > kHarm ? Weight::kFault : Weight::kDoubt;
  finding.detail = text;
  if (told_there) finding.detail += ", and " + also.channel->name + " jumps with them";
  if (unanswered) finding.detail += ", and the motion shows nothing of them";
  finding.detail += harm > kHarm ? ": check the cable and the range, then record again; or empty their cells, which "
                                   "--resample fills, or leave "
                                   "out the ends of the record that they are in (--from, --to)"
                                 : ": too small to matter much";
  return finding;
}

}  // namespace host_sim::data_check
