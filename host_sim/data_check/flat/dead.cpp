#include "host_sim/data_check/flat/dead.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host_sim/data_check/measures/statistics.hpp"

namespace host_sim::data_check {
namespace {

constexpr size_t kWindows = 40;
constexpr double kGrowth =
    10.0;  // energies of a passive rig fall; kinetic and potential energy trade a factor of 2 or so
constexpr double kVisible = 1e-4;  // of the largest energy: below it noise may be all there is

bool constant(const Channel& channel) {
  return std::all_of(channel.values.begin(), channel.values.end(),
                     [&](double value) { return value == channel.values.front(); });
}

bool is_force(const Channel& channel) { return channel.quantity == Quantity::kForce; }
bool is_base(const Channel& channel) { return channel.dof == rig_file::kBase; }

// Mean squares of the steps of all motion channels over windows, each channel by its own rms: how lively the rig is.
std::vector<double> liveliness(const Record& record) {
  std::vector<double> sum(kWindows, 0.0);
  const size_t length = record.samples() / kWindows;
  if (length < 4) return {};
  for (const Channel& channel : record.channels) {
    if (is_force(channel) || is_base(channel) || constant(channel)) continue;
    std::vector<double> window(kWindows, 0.0);
    const size_t lag = std::max<size_t>(1, length / 8);
    double largest = 0.0;
    for (size_t w = 0; w < kWindows; ++w) {
      for (size_t i = w * length; i + lag < (w + 1) * length; ++i)
        window[w] += (channel.values[i + lag] - channel.values[i]) * (channel.values[i + lag] - channel.values[i]);
      largest = std::max(largest, window[w]);
    }
    for (size_t w = 0; w < kWindows; ++w) sum[w] += window[w] / largest;
  }
  return sum;
}

// Once it has come alive, does the rig ever grow again from what is visible?
bool grows_again(const Record& record) {
  const std::vector<double> lively = liveliness(record);
  if (lively.empty()) return false;
  const double peak = *std::max_element(lively.begin(), lively.end());
  const auto alive = std::find_if(lively.begin(), lively.end(), [&](double value) { return value > 0.1 * peak; });
  double least = peak;
  for (auto at = alive; at != lively.end(); ++at) {
    least = std::min(least, std::max(*at, kVisible * peak));
    if (*at > kGrowth * least) return true;
  }
  return false;
}

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

std::string never_changes(const Channel& channel) {
  return fmt::format("never changes: all {} samples are {:.6g}", channel.values.size(),
                     channel.values.empty() ? 0.0 : channel.values.front());
}

}  // namespace

std::vector<std::optional<Finding>> find_dead(const Record& record, const std::vector<bool>& moves_elsewhere) {
  std::vector<std::optional<Finding>> findings(record.channels.size());
  const auto any = [&](auto predicate) {
    return std::any_of(record.channels.begin(), record.channels.end(), predicate);
  };
  const bool driven = any(drives);
  for (size_t i = 0; i < record.channels.size(); ++i) {
    const Channel& channel = record.channels[i];
    if (!constant(channel)) continue;
    Finding finding{"dead", Weight::kInforms, channel.name, never_changes(channel), std::nullopt};
    const bool partner_moves =
        any([&](const Channel& c) { return c.dof == channel.dof && !is_force(c) && !constant(c); });
    if (is_force(channel) || (is_base(channel) && !partner_moves)) {
      if (drives(channel)) {
        finding.detail += "; a command that is held: taken as a constant force";
      } else if (!driven && grows_again(record)) {
        finding.weight = Weight::kFault;
        finding.detail += ", yet the rig is driven: its motion grows again; is the sensor connected?";
      } else {
        finding.detail += is_base(channel) ? "; taken as a base that stands still"
                          : driven         ? "; taken as no force on this DOF"
                                           : "; taken as a free decay";
      }
    } else if (partner_moves) {
      finding.weight = Weight::kFault;
      finding.detail += ", while another channel of the same DOF moves: is the sensor connected?";
    } else if (moves_elsewhere[i]) {
      finding.weight = Weight::kDoubt;
      finding.detail += "; it moves in another record, so this DOF stands still here or the sensor had failed";
    } else {
      finding.weight = Weight::kFault;
      finding.detail += ", and nothing else tells of this DOF: is the sensor connected, does the DOF move?";
    }
    findings[i] = std::move(finding);
  }
  if (record.samples() < 32 * kWindows) return findings;
  std::vector<Life> lives;
  for (const Channel& channel : record.channels) lives.push_back(constant(channel) ? Life() : life_of(channel));
  for (size_t i = 0; i < record.channels.size(); ++i) {
    const bool may_stop = lives[i].steps.empty() || is_force(record.channels[i]) || is_base(record.channels[i]);
    const size_t window = may_stop ? 0 : dies_at(lives, i);  // a drive ends when it is switched off
    if (window == 0) continue;
    std::string text =
        fmt::format("stops for good near {:.4g} s, while the other channels go on: did the sensor fail, or its cable?",
                    static_cast<double>(window * (record.samples() / kWindows)) * record.sample_period_s);
    findings[i] = Finding{"dead", Weight::kFault, record.channels[i].name, text, std::nullopt};
  }
  return findings;
}

}  // namespace host_sim::data_check
