#include "host_sim/data_check/windows/decay_in.hpp"

#include <algorithm>
#include <numeric>

#include "host_sim/data_check/decay/decay_span.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kLeastPeriods = 4.0;  // of the decay: of fewer half of one is too much to lose

constexpr size_t kQuarters = 4;

// The mean of each.
std::vector<double> quarters(const Windows& energy, size_t from, size_t to) {
  std::vector<double> mean;
  for (size_t q = 0; q < kQuarters; ++q) {
    const size_t begin = from + q * (to - from) / kQuarters, end = from + (q + 1) * (to - from) / kQuarters;
    const auto at = [&](size_t i) { return energy.begin() + static_cast<std::ptrdiff_t>(i); };
    mean.push_back(std::accumulate(at(begin), at(end), 0.0) / static_cast<double>(end - begin));
  }
  return mean;
}

// The largest from there on.
Windows later_of(const Windows& energy, size_t from, size_t to) {
  Windows later = energy;
  for (size_t i = to - 1; i-- > from;) later[i] = std::max(later[i], later[i + 1]);
  return later;
}

// Whether the energy falls all along: to a quarter, or, in the little that is recorded of a long decay, by more than it may rise, and
// from each quarter of the time to the next by more than it ever rises.
bool falls(const Windows& energy, const Windows& later, size_t from, size_t to) {
  const std::vector<double> mean = quarters(energy, from, to);
  if (mean.back() <= kFalls * later[from]) return true;
  double rise = 1.0;
  for (size_t i = from; i < to; ++i) rise = std::max(rise, later[i] / energy[i]);
  for (size_t q = 0; q + 1 < kQuarters; ++q)
    if (mean[q] <= rise * mean[q + 1]) return false;
  return mean.front() > kRises * mean.back();
}

}  // namespace

std::optional<Decay> decay_in(const Windows& energy, const Span& span) {
  if (span.to < span.from + kHops * static_cast<size_t>(kLeastPeriods)) return std::nullopt;
  const Windows later = later_of(energy, span.from, span.to);
  size_t at = span.from;
  while (at + 1 < span.to && later[at + 1] > kRises * energy[at]) ++at;
  const auto window = [&](size_t i) { return energy.begin() + static_cast<std::ptrdiff_t>(i); };
  const auto rest = std::find_if(window(at), window(span.to), [&](double e) { return e < kRestEnergy * later[at]; });
  const double periods = static_cast<double>(rest - window(at)) / static_cast<double>(kHops);
  if (periods < kLeastPeriods || !falls(energy, later, at, span.to)) return std::nullopt;
  return Decay{at, span.to, periods, span.clipped && at == span.from};
}

bool falls_throughout(const Windows& energy) {
  if (energy.size() < kHops * static_cast<size_t>(kLeastPeriods)) return false;
  const Windows later = later_of(energy, 0, energy.size());
  for (size_t i = 0; i < energy.size(); ++i)
    if (later[i] > kRises * energy[i]) return false;
  const std::vector<double> mean = quarters(energy, 0, energy.size());
  return std::is_sorted(mean.rbegin(), mean.rend()) && mean.front() > kRises * mean.back();
}

}  // namespace host_sim::data_check
