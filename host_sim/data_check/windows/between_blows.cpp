#include "host_sim/data_check/windows/between_blows.hpp"

#include <algorithm>

#include "host_sim/data_check/decay/decay_span.hpp"
#include "host_sim/data_check/flat/clipping.hpp"
#include "host_sim/data_check/windows/loud.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kBlow = 4.0;  // within a period: it is doubled, as beats that a period's mean smooths never are

Windows::iterator at(Windows& energy, size_t i) { return energy.begin() + static_cast<std::ptrdiff_t>(i); }

}  // namespace

std::vector<Span> between_blows(const Windows& energy) {
  const double loud = loud_energy(energy);
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

}  // namespace host_sim::data_check
