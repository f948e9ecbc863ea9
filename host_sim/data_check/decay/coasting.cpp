#include "host_sim/data_check/decay/coasting.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "hal/rig_file/channel_name.hpp"
#include "host_sim/data_check/measures/statistics.hpp"
#include "host_sim/data_check/windows/loud.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kDeviations = 5.0;  // of noise: chance goes so far once in a million samples
constexpr size_t kWindows = 500;     // of a record: a decay is placed to so much of it
constexpr double kLost = 0.95;       // of the energy
constexpr double kHeld =
    3.0;  // times as long for the first twentieth as for the next: dry friction needs as long, drag less
constexpr size_t kFewest = 64;  // samples of a decay

bool turns_one_way(const std::vector<double>& rate) {
  const auto [least, most] = std::minmax_element(rate.begin(), rate.end());
  return *most > 0.0 ? *least >= -std::sqrt(kRestEnergy) * *most : true;
}

// Mean rates over windows. Empty where the channel is no rate of something that may turn one way, or it turns back.
std::vector<double> one_way_rates(const Channel& channel, size_t window) {
  const auto name = rig_file::parse_channel_name(channel.name);
  const bool angle = channel.quantity == Quantity::kDisplacement && name && name->rotating;
  if (!angle && !keeps_its_sign(channel)) return {};
  const std::vector<double>& y = channel.values;
  std::vector<double> rate;
  double sum = 0.0;
  for (size_t from = 0; from + window < y.size(); from += window) {
    double mean = y[from + window] - y[from];
    if (!angle) {
      mean = 0.0;
      for (size_t i = from; i < from + window; ++i) mean += y[i];
    }
    rate.push_back(mean), sum += mean;
  }
  if (sum < 0.0)
    for (double& value : rate) value = -value;
  return turns_one_way(rate) ? rate : std::vector<double>();
}

// Of all DOFs, each in units of its own mean; empty where one of them does not keep its sign.
std::vector<double> energies(const Record& record, size_t window) {
  std::vector<double> energy;
  std::set<int> dofs;
  for (const Channel& channel : record.channels) {
    if (channel.quantity == Quantity::kForce || !dofs.insert(channel.dof).second) continue;
    const Channel* rate_of = record.find(Quantity::kVelocity, channel.dof);
    if (rate_of == nullptr) rate_of = record.find(Quantity::kDisplacement, channel.dof);
    const std::vector<double> rate = rate_of == nullptr ? std::vector<double>() : one_way_rates(*rate_of, window);
    double square = 0.0;
    for (const double value : rate) square += value * value;
    if (!(square > 0.0)) return {};
    energy.resize(rate.size());
    for (size_t i = 0; i < rate.size(); ++i) energy[i] += rate[i] * rate[i] / square;
  }
  return energy;
}

// How many windows from `from` on have at least that energy; up to `to`.
size_t windows_above(const std::vector<double>& energy, size_t from, size_t to, double least) {
  size_t last = from;
  for (size_t i = from; i < to; ++i)
    if (energy[i] >= least) last = i + 1;
  return last - from;
}

}  // namespace

bool keeps_its_sign(const Channel& channel) {
  if (channel.quantity != Quantity::kVelocity) return false;
  const Statistics s = statistics_of(channel);
  const double small = std::max(kDeviations * s.noise, std::sqrt(kRestEnergy) * std::max(s.highest, -s.lowest));
  return s.lowest >= -small || s.highest <= small;
}

std::vector<DecaySpan> coasting_decays(const Record& record) {
  const size_t window = std::max<size_t>(1, record.samples() / kWindows);
  const std::vector<double> energy = energies(record, window);
  if (energy.empty()) return {};
  const double largest = *std::max_element(energy.begin(), energy.end());
  std::vector<DecaySpan> spans;
  for (size_t at = 0; at < energy.size();) {
    // up to its maximum, and down from there until it rises again
    size_t peak = at, lowest = at, end = at;
    for (; end < energy.size(); ++end) {
      if (energy[end] > kRises * std::max(energy[lowest], kRestEnergy * largest) &&
          energy[lowest] < kFalls * energy[peak])
        break;
      if (energy[end] >= energy[peak]) peak = lowest = end;
      if (energy[end] < energy[lowest]) lowest = end;
    }
    const bool goes_on = end < energy.size();
    const double from_energy = energy[peak];
    if (energy[lowest] <= kFalls * from_energy && from_energy > loud_energy(energy)) {
      const size_t first = at == 0 && energy[0] >= kLost * from_energy ? 0 : peak;
      const size_t top = windows_above(energy, first, end, kLost * from_energy),
                   next = windows_above(energy, first + top, end, kLost * kLost * from_energy);
      const bool from_start = first == 0 && static_cast<double>(top) <= kHeld * static_cast<double>(next + 1);
      const size_t from = from_start ? 0 : (first + top) * window, to = goes_on ? lowest * window : record.samples();
      if (to >= from + kFewest) spans.push_back({from, to, false});
    }
    at = std::max(at + 1, goes_on ? lowest + 1 : end);
  }
  const auto is_in_decay = [&](size_t i) {
    return std::any_of(spans.begin(), spans.end(),
                       [&](const DecaySpan& s) { return i * window >= s.from && i * window < s.to; });
  };
  return !spans.empty() && decays_enough(energy, is_in_decay) ? spans : std::vector<DecaySpan>();
}

}  // namespace host_sim::data_check
