#include "host_sim/data_check/windows/energy.hpp"

#include <algorithm>

#include "host_sim/data_check/measures/statistics.hpp"

namespace host_sim::data_check {
namespace {

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

}  // namespace

std::map<int, const Channel*> rate_channels(const Record& record) {
  std::map<int, const Channel*> channels;
  for (const Channel& channel : record.channels)
    if (channel.quantity != Quantity::kForce) channels[channel.dof] = rate_channel(record, channel.dof);
  return channels;
}

Windows energies(const std::map<int, const Channel*>& channels, size_t hop) {
  Windows energy;
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

}  // namespace host_sim::data_check
