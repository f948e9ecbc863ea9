#include "host_sim/data_check/decay/release.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/data_check/decay/coasting.hpp"
#include "host_sim/data_check/flat/clipping.hpp"
#include "host_sim/data_check/measures/period.hpp"
#include "host_sim/data_check/measures/statistics.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kRises = 1.21;       // of the energy: a tenth of the motion, which noise and beats below it make
constexpr double kFalls = 0.25;       // the motion is halved
constexpr double kBlow = 4.0;         // within a period: it is doubled, as beats that a period's mean smooths never are
constexpr double kLoud = 0.05;        // of the largest energy: less is no blow worth a decay
constexpr double kShareOfIt = 0.25;   // of what is loud, at least, has to be decay: else something drives the rig
constexpr size_t kMostRecords = 8;    // of one call
constexpr double kRestEnergy = 0.01;  // of the largest: a tenth of the motion
constexpr size_t kLeastSamples = 128;  // of a record that estimate and diagnose both take
constexpr double kLeastPeriods = 4.0;  // of the decay: of fewer half of one is too much to lose
constexpr double kLongPeriods = 16.0;  // of so many a whole one is not
constexpr size_t kHops = 4;            // windows that begin within a period

bool is_driven(const Record& record) { return std::any_of(record.channels.begin(), record.channels.end(), drives); }

// The channel of a DOF that is nearest to its rate.
const Channel* rate_channel(const Record& record, int dof) {
  for (const Quantity q : {Quantity::kVelocity, Quantity::kDisplacement, Quantity::kAcceleration})
    if (const Channel* channel = record.find(q, dof)) return channel;
  return nullptr;
}

// What goes with the rate, with little of the noise: differences of a displacement over an eighth of a period, means of anything else.
std::vector<double> rates(const Channel& channel, size_t eighth) {
  const std::vector<double>& y = channel.values;
  const double mean = mean_and_rms(y).mean;
  std::vector<double> sum(y.size() + 1, 0.0);
  for (size_t i = 0; i < y.size(); ++i) sum[i + 1] = sum[i] + (y[i] - mean);
  std::vector<double> out;
  for (size_t i = 0; i + 2 * eighth <= y.size(); ++i) {
    const double here = sum[i + eighth] - sum[i];
    out.push_back(channel.quantity == Quantity::kDisplacement ? sum[i + 2 * eighth] - sum[i + eighth] - here : here);
  }
  return out;
}

// Mean squares over one period each, every quarter of a period, of all DOFs, each in units of its own mean.
std::vector<double> energies(const std::map<int, const Channel*>& channels, size_t hop) {
  std::vector<double> energy;
  for (const auto& [dof, channel] : channels) {
    const std::vector<double> rate = rates(*channel, std::max<size_t>(1, hop / 2));
    std::vector<double> square(rate.size() + 1, 0.0);
    for (size_t i = 0; i < rate.size(); ++i) square[i + 1] = square[i] + rate[i] * rate[i];
    if (!(square.back() > 0.0)) continue;
    size_t n = 0;
    for (size_t from = 0; from + kHops * hop <= rate.size(); from += hop, ++n) {
      if (n == energy.size()) energy.push_back(0.0);
      energy[n] += (square[from + kHops * hop] - square[from]) / square.back();
    }
  }
  return energy;
}

using Windows = std::vector<double>;
Windows::iterator at(Windows& energy, size_t i) { return energy.begin() + static_cast<std::ptrdiff_t>(i); }

// From where to where windows show no blow; the window behind the last of them does.
struct Span {
  size_t from = 0, to = 0;
  bool clipped = false;  // up to there
};
std::vector<Span> between_blows(const Windows& energy) {
  const double loud = kLoud * *std::max_element(energy.begin(), energy.end());
  std::vector<Span> spans = {{0, energy.size()}};
  for (size_t i = 0; i + kHops < energy.size();) {
    const auto ahead = energy.begin() + static_cast<std::ptrdiff_t>(i);
    const auto reach = static_cast<std::ptrdiff_t>(std::min(2 * kHops + 1, energy.size() - i));
    if (energy[i + kHops] <= kBlow * energy[i] || *std::max_element(ahead, ahead + reach) <= loud) {
      ++i;
      continue;
    }
    size_t risen = i + 1;  // it has risen fourfold after kHops windows: by more than kRises in one of them
    while (energy[risen] <= kRises * energy[risen - 1]) ++risen;
    spans.back().to = risen - 1;
    spans.push_back({risen, energy.size()});
    while (risen + 1 < energy.size() && energy[risen + 1] > energy[risen]) ++risen;
    i = risen;
  }
  return spans;
}

// Whether the energy falls all along: to a quarter, or, in the little that is recorded of a long decay, by more than it may rise, and
// from each quarter of the time to the next by more than it ever rises.
bool falls(const Windows& energy, const Windows& later, size_t from, size_t to) {
  constexpr size_t kQuarters = 4;
  std::vector<double> mean;
  for (size_t q = 0; q < kQuarters; ++q) {
    const size_t begin = from + q * (to - from) / kQuarters, end = from + (q + 1) * (to - from) / kQuarters;
    const auto at = [&](size_t i) { return energy.begin() + static_cast<std::ptrdiff_t>(i); };
    mean.push_back(std::accumulate(at(begin), at(end), 0.0) / static_cast<double>(end - begin));
  }
  if (mean.back() <= kFalls * later[from]) return true;
  double rise = 1.0;
  for (size_t i = from; i < to; ++i) rise = std::max(rise, later[i] / energy[i]);
  for (size_t q = 0; q + 1 < kQuarters; ++q)
    if (mean[q] <= rise * mean[q + 1]) return false;
  return mean.front() > kRises * mean.back();
}

// In windows; from: the first that has all its energy. Nothing where the span is no decay.
struct Decay {
  size_t from = 0, to = 0;
  double periods = 0.0;  // until it is at rest
  bool clipped = false;  // up to its first
};
std::optional<Decay> decay_in(const Windows& energy, const Span& span) {
  if (span.to < span.from + kHops * static_cast<size_t>(kLeastPeriods)) return std::nullopt;
  Windows later = energy;  // the largest from there on
  for (size_t i = span.to - 1; i-- > span.from;) later[i] = std::max(later[i], later[i + 1]);
  size_t at = span.from;
  while (at + 1 < span.to && later[at + 1] > kRises * energy[at]) ++at;
  const auto window = [&](size_t i) { return energy.begin() + static_cast<std::ptrdiff_t>(i); };
  const auto rest = std::find_if(window(at), window(span.to), [&](double e) { return e < kRestEnergy * later[at]; });
  const double periods = static_cast<double>(rest - window(at)) / static_cast<double>(kHops);
  if (periods < kLeastPeriods || !falls(energy, later, at, span.to)) return std::nullopt;
  return Decay{at, span.to, periods, span.clipped && at == span.from};
}

// What is clipped of a decay is its beginning, and it begins a quarter of a period behind that: what was clipped dies away first, and
// an amplifier recovers. The windows before are no part of the motion that is seen.
void begin_behind_clipping(const Record& record, size_t hop, std::vector<Span>& spans, Windows& energy) {
  std::vector<size_t> ends;
  for (const Channel& channel : record.channels)
    for (const Run& run : clipped_runs(channel, record)) ends.push_back(run.first + run.length);
  for (Span& span : spans) {
    size_t behind = span.from * hop;
    for (const size_t end : ends)
      if (end <= (span.to + kHops - 1) * hop) behind = std::max(behind, end);
    if (!(span.clipped = behind > span.from * hop)) continue;
    const size_t first = std::min(span.to, (behind + 2 * hop - 1) / hop);
    std::fill(at(energy, span.from), at(energy, first), 0.0);
    span.from = first;
  }
}

// Whether decays are what the record shows when it is loud.
bool decays_enough(const Windows& energy, const std::vector<Decay>& decays) {
  const double loud = kLoud * *std::max_element(energy.begin(), energy.end());
  size_t all = 0, in_decays = 0;
  for (size_t i = 0; i < energy.size(); ++i) {
    if (energy[i] <= loud) continue;
    ++all;
    in_decays += std::any_of(decays.begin(), decays.end(), [&](const Decay& d) { return i >= d.from && i < d.to; });
  }
  return static_cast<double>(in_decays) > kShareOfIt * static_cast<double>(all);
}

// In the order of time. silent: at rest, beside another; noise that happens to fall is no decay.
struct FoundDecay {
  DecaySpan span;
  bool silent = false;
};

std::vector<FoundDecay> found_decays(const Record& record) {
  if (record.samples() < 64 || is_driven(record)) return {};
  if (std::vector<DecaySpan> coasting = coasting_decays(record); !coasting.empty()) {
    std::vector<FoundDecay> found;
    for (const DecaySpan& span : coasting) found.push_back({span});
    return found;
  }
  std::map<int, const Channel*> channels;
  double period = 0.0;
  for (const Channel& channel : record.channels)
    if (channel.quantity != Quantity::kForce) channels[channel.dof] = rate_channel(record, channel.dof);
  for (const auto& [dof, channel] : channels) period = std::max(period, period_of(channel->values));
  const auto hop = static_cast<size_t>(std::lround(period / kHops));
  if (hop < 1) return {};
  Windows energy = energies(channels, hop);
  if (energy.empty()) return {};
  std::vector<Span> parts = between_blows(energy);
  begin_behind_clipping(record, hop, parts, energy);
  std::vector<Decay> decays;
  for (const Span& span : parts)
    if (const auto decay = decay_in(energy, span)) decays.push_back(*decay);
  if (decays.empty() || !decays_enough(energy, decays)) return {};
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

// Those that tell of the rig, and the others: of noise before a blow, and too short ones beside one that is long enough.
struct SortedDecays {
  std::vector<DecaySpan> kept, dropped;
};
SortedDecays sorted_decays(const Record& record) {
  const std::vector<FoundDecay> found = found_decays(record);
  const auto tells = [](const FoundDecay& d) { return !d.silent && d.span.to >= d.span.from + kLeastSamples; };
  const bool any = std::any_of(found.begin(), found.end(), tells);
  SortedDecays sorted;
  for (const FoundDecay& d : found) (any && !tells(d) ? sorted.dropped : sorted.kept).push_back(d.span);
  return sorted;
}

}  // namespace

std::vector<DecaySpan> free_decays(const Record& record) { return sorted_decays(record).kept; }

namespace {

// Nothing where the decays are the whole record.
std::optional<Finding> finding_of(const Record& record, const SortedDecays& sorted) {
  const std::vector<DecaySpan>& decays = sorted.kept;
  if (decays.empty() || (decays.size() == 1 && decays[0].from == 0 && decays[0].to == record.samples()))
    return std::nullopt;
  const auto at = [&](size_t sample) { return said_instant_s(record, static_cast<double>(sample)); };
  const auto listed = [&](const std::vector<DecaySpan>& spans) {
    std::string list;
    for (const DecaySpan& d : spans) list += (list.empty() ? "" : ", ") + at(d.from) + " to " + at(d.to) + " s";
    return list;
  };
  const bool clipped = std::any_of(decays.begin(), decays.end(), [](const DecaySpan& d) { return d.clipped; });
  return Finding{"release", Weight::kInforms, "",
                 "decays freely from " + listed(decays) + "; elsewhere " +
                     (clipped ? "a channel is at the end of its range, or " : "") +
                     "energy comes in that no force channel tells of (a hand, a pull, a blow; a hidden "
                     "mass that beats with it): left out by estimate and diagnose" +
                     (sorted.dropped.empty()
                          ? ""
                          : ", and so is " + listed(sorted.dropped) + ", which is at rest or too short to tell"),
                 static_cast<double>(decays[0].from) * record.sample_period_s};
}

}  // namespace

std::optional<Finding> find_release(const Record& record) { return finding_of(record, sorted_decays(record)); }

std::vector<std::string> keep_decays(std::vector<Record>& records) {
  std::vector<std::string> told;
  std::vector<Record> kept;
  size_t room = records.size() < kMostRecords ? kMostRecords - records.size() : 0;
  for (Record& record : records) {
    const SortedDecays sorted = sorted_decays(record);
    const auto finding = finding_of(record, sorted);
    if (!finding) {
      kept.push_back(std::move(record));
      continue;
    }
    told.push_back(record.file + ": " + finding->detail);
    size_t number = 0;
    for (const DecaySpan& d : sorted.kept) {
      if (number > 0 && room == 0) break;
      room -= number > 0 ? 1 : 0;
      Record part = record;
      if (++number > 1) part.file += fmt::format(", decay {}", number);
      for (Channel& channel : part.channels) {
        const auto begin = channel.values.begin();
        channel.values = {begin + static_cast<std::ptrdiff_t>(d.from), begin + static_cast<std::ptrdiff_t>(d.to)};
      }
      part.start_s += static_cast<double>(d.from) * record.sample_period_s;
      kept.push_back(std::move(part));
    }
  }
  records = std::move(kept);
  return told;
}

}  // namespace host_sim::data_check
