#include "host_sim/data_check/decay/free_decays.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/data_check/decay/coasting.hpp"
#include "host_sim/data_check/measures/period.hpp"
#include "host_sim/data_check/measures/statistics.hpp"
#include "host_sim/data_check/windows/between_blows.hpp"
#include "host_sim/data_check/windows/decay_in.hpp"
#include "host_sim/data_check/windows/energy.hpp"
#include "host_sim/data_check/windows/loud.hpp"
#include "host_sim/records/record_checks.hpp"

namespace host_sim::data_check {
namespace {

constexpr size_t kLeastSamples = 128;  // of a record that estimate and diagnose both take
constexpr double kLongPeriods = 16.0;  // of so many a whole one is not too much to lose
constexpr double kSlower =
    2.0;  // times the period: a window of one is then half a swing, which is as loud as any other

// In the order of time. silent: at rest, beside another; noise that happens to fall is no decay.
struct FoundDecay {
  DecaySpan span;
  bool silent = false;
};

// Of what swings with that period.
std::vector<FoundDecay> decays_of(const Record& record, const std::map<int, const Channel*>& channels, double period) {
  const auto hop = static_cast<size_t>(std::lround(period / kHops));
  if (hop < 1) return {};
  Windows energy = energies(channels, hop);
  if (energy.empty()) return {};
  std::vector<Span> parts = between_blows(energy);
  begin_behind_clipping(record, hop, parts, energy);
  std::vector<Decay> decays;
  for (const Span& span : parts)
    if (const auto decay = decay_in(energy, span)) decays.push_back(*decay);
  const auto is_in_decay = [&decays](size_t i) {
    return std::any_of(decays.begin(), decays.end(), [i](const Decay& d) { return i >= d.from && i < d.to; });
  };
  if (decays.empty() || !decays_enough(energy, is_in_decay)) return {};
  std::vector<FoundDecay> found;
  const double rest = kRestEnergy * *std::max_element(energy.begin(), energy.end());
  for (const Decay& d : decays) {
    // an accelerometer shows the blow itself, at the end of the first period that has all its energy
    const size_t lost = d.from == 0 || d.clipped ? 0 : d.periods < kLongPeriods ? kHops / 2 : kHops;
    const size_t to = d.to == energy.size() ? record.samples() : (d.to + kHops - 1) * hop;
    found.push_back({{(d.from + lost) * hop, to, d.clipped}, energy[d.from] < rest});
  }
  return found;
}

// Of what swings. Where a fast mode has died away and a slow one swings on, the mean square over a period of the fast one rises and
// falls with the slow one's swing. Over a period of the slow one it falls all along, if nothing comes in.
std::vector<FoundDecay> swinging_decays(const Record& record) {
  const std::map<int, const Channel*> channels = rate_channels(record);
  double period = 0.0, slowest = 0.0;
  for (const auto& [dof, channel] : channels) {
    period = std::max(period, period_of(channel->values));
    slowest = std::max(slowest, slowest_period_of(channel->values, kRestEnergy));
  }
  std::vector<FoundDecay> found = decays_of(record, channels, period);
  const bool clipped = std::any_of(found.begin(), found.end(), [](const FoundDecay& d) { return d.span.clipped; });
  if (found.empty() || clipped || slowest < kSlower * period) return found;
  const auto hop = static_cast<size_t>(std::lround(slowest / kHops));
  if (falls_throughout(energies(channels, hop))) return {{{0, record.samples(), false}}};
  return found;
}

std::vector<FoundDecay> found_decays(const Record& record) {
  if (record.samples() < 64 || has_drive(record)) return {};
  if (std::vector<DecaySpan> coasting = coasting_decays(record); !coasting.empty()) {
    std::vector<FoundDecay> found;
    for (const DecaySpan& span : coasting) found.push_back({span});
    return found;
  }
  return swinging_decays(record);
}

}  // namespace

SortedDecays sorted_decays(const Record& record) {
  const std::vector<FoundDecay> found = found_decays(record);
  const auto tells = [](const FoundDecay& d) { return !d.silent && d.span.to >= d.span.from + kLeastSamples; };
  const bool any = std::any_of(found.begin(), found.end(), tells);
  SortedDecays sorted;
  for (const FoundDecay& d : found) (any && !tells(d) ? sorted.dropped : sorted.kept).push_back(d.span);
  return sorted;
}

std::vector<DecaySpan> free_decays(const Record& record) { return sorted_decays(record).kept; }

}  // namespace host_sim::data_check
