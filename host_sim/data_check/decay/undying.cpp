#include "host_sim/data_check/decay/undying.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host_sim/data_check/decay/free_decays.hpp"
#include "host_sim/data_check/measures/period.hpp"
#include "host_sim/data_check/measures/statistics.hpp"
#include "host_sim/data_check/windows/energy.hpp"
#include "host_sim/records/record_checks.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kRise = 2.0, kLeastCrest = 0.05;
constexpr size_t kFewestCrests = 5;
constexpr double kNotFallen = 0.5;

}  // namespace

std::vector<double> crests(const std::vector<double>& energy) {
  if (energy.empty()) return {};
  const double least = kLeastCrest * *std::max_element(energy.begin(), energy.end());
  std::vector<double> found;
  double trough = energy.front(), crest = 0.0;  // crest 0: on the way down
  for (const double e : energy) {
    if (crest == 0.0) {
      trough = std::min(trough, e);
      if (e > kRise * trough && e > least) crest = e;
    } else {
      crest = std::max(crest, e);
      if (e * kRise < crest) found.push_back(crest), crest = 0.0, trough = e;
    }
  }
  return found;
}

std::optional<Finding> find_undying(const Record& record) {
  if (has_drive(record)) return std::nullopt;
  const std::map<int, const Channel*> channels = rate_channels(record);
  double period = 0.0;
  for (const auto& [dof, channel] : channels) period = std::max(period, period_of(channel->values));
  const auto hop = static_cast<size_t>(std::lround(period / kHops));
  if (hop < 1) return std::nullopt;
  const Windows energy = energies(channels, hop);
  std::vector<DecaySpan> spans = free_decays(record);
  if (spans.empty()) spans.push_back({0, record.samples(), false});
  size_t most = 0;
  for (const DecaySpan& span : spans) {
    const size_t from = std::min(energy.size(), span.from / hop), to = std::min(energy.size(), span.to / hop);
    const std::vector<double> found =
        crests({energy.begin() + static_cast<std::ptrdiff_t>(from), energy.begin() + static_cast<std::ptrdiff_t>(to)});
    if (found.size() < kFewestCrests) continue;
    const auto middle = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
    const double earlier = mean_and_rms({found.begin(), middle}).mean, later = mean_and_rms({middle, found.end()}).mean;
    if (later >= kNotFallen * earlier) most = std::max(most, found.size());
  }
  if (most == 0) return std::nullopt;
  return Finding{"work", Weight::kDoubt, "",
                 fmt::format("does not decay: its energy doubles again {} times and the crests do not fall, and no "
                             "force and no base is recorded: what drives the rig has to be in the file",
                             most),
                 static_cast<double>(most)};
}

}  // namespace host_sim::data_check
