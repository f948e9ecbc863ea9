#include "host_sim/records/csv/blanks/held_commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host_sim/records/times/even_times.hpp"

namespace host_sim {
namespace {

constexpr double kRarer = 10.0, kFarRarer = 100.0;  // than the values of the channel that has most
// A smooth curve of eight samples a period (as the resampling wants it) is missed by the cubic through its neighbours with 8 % of its
// height, and by the value before with 54 %; steps by chance are missed by both alike.
constexpr double kSmooth = 0.5;
constexpr size_t kTells = 8;  // values: of fewer none says that they are smooth

struct Own {
  std::vector<double> time_s, values;
  double step_s() const { return time_s.size() < 2 ? time_s.empty() ? 0.0 : INFINITY : median_step(time_s); }
};

Own own_of(const std::vector<double>& time_s, const std::vector<double>& values) {
  Own own;
  for (size_t row = 0; row < values.size(); ++row)
    if (!std::isnan(values[row])) own.time_s.push_back(time_s[row]), own.values.push_back(values[row]);
  return own;
}

// Whether the cubic through its neighbours misses a value by far less than the value before does.
bool is_smooth(const Own& own) {
  if (own.values.size() < kTells) return false;
  double by_cubic = 0.0, by_hold = 0.0;
  for (size_t i = 2; i + 2 < own.values.size(); ++i) {
    const double around_s[4] = {own.time_s[i - 2], own.time_s[i - 1], own.time_s[i + 1], own.time_s[i + 2]};
    const double around[4] = {own.values[i - 2], own.values[i - 1], own.values[i + 1], own.values[i + 2]};
    double weight[4], off = 0.0;
    weights_at(around_s, 4, own.time_s[i], weight);
    for (size_t j = 0; j < 4; ++j) off += weight[j] * (around[j] - own.values[i]);
    by_cubic += off * off;
    by_hold += std::pow(own.values[i] - own.values[i - 1], 2);
  }
  return by_cubic < kSmooth * kSmooth * by_hold;
}

bool is_command(const Own& own, double fastest_s) {
  if (own.values.empty() || own.step_s() < kRarer * fastest_s) return false;
  return own.step_s() >= kFarRarer * fastest_s || !is_smooth(own);
}

void hold(std::vector<double>& values) {
  for (size_t row = 1; row < values.size(); ++row)
    if (std::isnan(values[row])) values[row] = values[row - 1];
}

}  // namespace

std::vector<std::string> hold_commands(const std::vector<double>& time_s, std::vector<Channel>& channels) {
  std::vector<std::string> notes;
  std::vector<Own> own;
  double fastest_s = INFINITY;
  for (const Channel& channel : channels) {
    own.push_back(own_of(time_s, channel.values));
    if (own.back().values.size() > 1) fastest_s = std::min(fastest_s, own.back().step_s());
  }
  for (size_t c = 0; c < channels.size(); ++c) {
    if (channels[c].quantity != Quantity::kForce || !is_command(own[c], fastest_s)) continue;
    hold(channels[c].values);
    channels[c].held = true;
    notes.push_back(fmt::format(
        "{}: {} values in {} rows: a command that is written now and then, held from each value to the next",
        channels[c].name, own[c].values.size(), time_s.size()));
  }
  return notes;
}

}  // namespace host_sim
