#include "host_sim/data_check/release.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/data_check/statistics.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kRises = 1.21;        // of the energy: a tenth of the motion, which noise and beats below it make
constexpr double kFalls = 0.25;        // the motion is halved
constexpr double kRestEnergy = 0.01;   // of the largest: a tenth of the motion
constexpr double kLeastPeriods = 4.0;  // of the decay: of fewer half of one is too much to lose
constexpr double kLongPeriods = 16.0;  // of so many a whole one is not
constexpr size_t kHops = 4;            // a period
constexpr double kSwings = 0.5;        // of the rms: turns beyond it on both sides are swings, not noise

bool is_driven(const Record& record) {
  return std::any_of(record.channels.begin(), record.channels.end(), [](const Channel& c) {
    return (c.quantity == Quantity::kForce || c.dof == rig_file::kBase) && mean_and_rms(c.values).rms > 0.0;
  });
}

// In samples: twice the usual time from a swing to one side to a swing to the other. 0: fewer than four.
double period_of(const std::vector<double>& y) {
  const auto about = mean_and_rms(y);
  std::vector<double> half;
  int side = 0;
  size_t since = 0;
  for (size_t i = 0; i < y.size(); ++i) {
    const double off = y[i] - about.mean;
    const int now = off > kSwings * about.rms ? 1 : off < -kSwings * about.rms ? -1 : 0;
    if (now == 0 || now == side) continue;
    if (side != 0) half.push_back(static_cast<double>(i - since));
    side = now, since = i;
  }
  if (half.size() < 4) return 0.0;
  const auto middle = half.begin() + static_cast<std::ptrdiff_t>(half.size() / 2);
  std::nth_element(half.begin(), middle, half.end());
  return 2.0 * *middle;
}

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

}  // namespace

size_t samples_before_release(const Record& record) {
  if (record.samples() < 64 || is_driven(record)) return 0;
  std::map<int, const Channel*> channels;
  double period = 0.0;
  for (const Channel& channel : record.channels)
    if (channel.quantity != Quantity::kForce) channels[channel.dof] = rate_channel(record, channel.dof);
  for (const auto& [dof, channel] : channels) period = std::max(period, period_of(channel->values));
  const auto hop = static_cast<size_t>(period / kHops + 0.5);
  if (hop < 1) return 0;
  const std::vector<double> energy = energies(channels, hop);
  if (energy.empty()) return 0;
  std::vector<double> later = energy;  // the largest from there on
  for (size_t i = later.size() - 1; i-- > 0;) later[i] = std::max(later[i], later[i + 1]);
  size_t at = 0;
  while (at + 1 < energy.size() && later[at + 1] > kRises * energy[at]) ++at;
  if (at == 0) return 0;
  // it has to decay from there, for long enough to lose a period of it
  const auto end = std::find_if(energy.begin() + static_cast<std::ptrdiff_t>(at), energy.end(),
                                [&](double e) { return e < kRestEnergy * later[at]; });
  const auto left = static_cast<double>(end - energy.begin()) - static_cast<double>(at);
  const double last =
      std::accumulate(energy.end() - static_cast<std::ptrdiff_t>((energy.size() - at + 3) / 4), energy.end(), 0.0) /
      static_cast<double>((energy.size() - at + 3) / 4);
  if (left < kHops * kLeastPeriods || last > kFalls * later[at]) return 0;
  // an accelerometer shows the blow itself, at the end of the first period that has all its energy
  return (at + (left < kHops * kLongPeriods ? kHops / 2 : kHops)) * hop;
}

std::optional<Finding> find_release(const Record& record) {
  const size_t led = samples_before_release(record);
  if (led == 0) return std::nullopt;
  const double led_s = static_cast<double>(led) * record.sample_period_s;
  return Finding{
      "release", Weight::kInforms, "",
      fmt::format("the first {:.3g} s are no free decay, and no force is recorded that would explain them (a hand, a "
                  "pull, a blow): left out by estimate and diagnose",
                  led_s),
      led_s};
}

std::vector<std::string> begin_at_release(std::vector<Record>& records) {
  std::vector<std::string> told;
  for (Record& record : records) {
    const auto finding = find_release(record);
    if (!finding) continue;
    told.push_back(record.file + ": " + finding->detail);
    const auto led = static_cast<std::ptrdiff_t>(samples_before_release(record));
    for (Channel& channel : record.channels) channel.values.erase(channel.values.begin(), channel.values.begin() + led);
    record.start_s += static_cast<double>(led) * record.sample_period_s;
  }
  return told;
}

}  // namespace host_sim::data_check
