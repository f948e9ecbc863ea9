#include "host_sim/data_check/flat/stops.hpp"

#include <algorithm>

#include "host_sim/data_check/measures/statistics.hpp"
#include "host_sim/records/record_checks.hpp"

namespace host_sim::data_check {
namespace {

constexpr size_t kWindows = 40;

// How lively a channel is in each window (mean square of steps over an eighth of a window), and how much of that is
// white from sample to sample.
struct Life {
  std::vector<double> steps, white;
};
Life life_of(const Channel& channel) {
  Life life;
  const size_t length = channel.values.size() / kWindows, lag = std::max<size_t>(1, length / 8);
  for (size_t w = 0; w < kWindows; ++w) {
    life.steps.push_back(mean_square_step(channel.values, w * length, (w + 1) * length, lag));
    life.white.push_back(mean_square_step(channel.values, w * length, (w + 1) * length, 1));
  }
  return life;
}

// The window from which on a channel is gone for good: nothing but white noise to the end of the record, a thirtieth of
// the life that it had just before, while the rest of the rig goes on as lively (a third of it at least). Only what is more than white
// noise itself tells that something goes on: the noise of a force does when the drive is off and the rig has come to rest. 0: none.
size_t dies_at(const std::vector<Life>& all, size_t which) {
  constexpr double kDrop = 30.0, kGoesOn = 3.0, kWhite = 1.5;
  constexpr size_t kFewest = kWindows / 10;
  const Life& life = all[which];
  size_t first = kWindows;
  while (first > 0 && life.steps[first - 1] <= kWhite * life.white[first - 1]) --first;
  if (first < 2 || kWindows - first < kFewest) return 0;
  if (life.steps[first] * kDrop > life.steps[first - 2]) return 0;
  const auto mean = [](const std::vector<double>& values, size_t from, size_t to) {
    double sum = 0.0;
    for (size_t i = from; i < to; ++i) sum += values[i] / static_cast<double>(to - from);
    return sum;
  };
  bool any = false;
  for (size_t i = 0; i < all.size(); ++i) {
    if (i == which || all[i].steps.empty()) continue;
    const double before = mean(all[i].steps, first >= 6 ? first - 6 : 0, first - 1),
                 later = mean(all[i].steps, first, kWindows);
    if (!(before > 0.0)) continue;
    if (later * kGoesOn < before) return 0;
    any = any || later > kWhite * mean(all[i].white, first, kWindows);
  }
  return any ? first : 0;
}

}  // namespace

std::vector<size_t> stops_of(const Record& record) {
  std::vector<size_t> stops(record.channels.size(), 0);
  if (record.samples() < 32 * kWindows) return stops;
  std::vector<Life> lives;
  for (const Channel& channel : record.channels) lives.push_back(is_constant(channel) ? Life() : life_of(channel));
  for (size_t i = 0; i < record.channels.size(); ++i) {
    const Channel& channel = record.channels[i];
    const bool may_stop =  // a drive ends when it is switched off
        lives[i].steps.empty() || is_drive(channel);
    if (!may_stop) stops[i] = dies_at(lives, i) * (record.samples() / kWindows);
  }
  return stops;
}

}  // namespace host_sim::data_check
