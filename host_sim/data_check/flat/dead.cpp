#include "host_sim/data_check/flat/dead.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host_sim/data_check/flat/stops.hpp"
#include "host_sim/data_check/measures/statistics.hpp"
#include "host_sim/records/record_checks.hpp"

namespace host_sim::data_check {
namespace {

constexpr size_t kWindows = 40;
constexpr double kGrowth =
    10.0;  // energies of a passive rig fall; kinetic and potential energy trade a factor of 2 or so
constexpr double kVisible = 1e-4;  // of the largest energy: below it noise may be all there is

bool is_force(const Channel& channel) { return channel.quantity == Quantity::kForce; }
bool is_base(const Channel& channel) { return channel.dof == rig_file::kBase; }

// Mean squares of the steps of all motion channels over windows, each channel by its own rms: how lively the rig is.
std::vector<double> liveliness(const Record& record) {
  std::vector<double> sum(kWindows, 0.0);
  const size_t length = record.samples() / kWindows;
  if (length < 4) return {};
  for (const Channel& channel : record.channels) {
    if (is_force(channel) || is_base(channel) || is_constant(channel)) continue;
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

std::string never_changes(const Channel& channel) {
  return fmt::format("never changes: all {} samples are {:.6g}", channel.values.size(),
                     channel.values.empty() ? 0.0 : channel.values.front());
}

Finding finding_of(const Record& record, const Channel& channel, bool moves_elsewhere) {
  const auto any = [&](auto predicate) {
    return std::any_of(record.channels.begin(), record.channels.end(), predicate);
  };
  Finding finding{"dead", Weight::kInforms, channel.name, never_changes(channel), std::nullopt};
  const bool driven = any(drives);
  const bool partner_moves =
      any([&](const Channel& c) { return c.dof == channel.dof && !is_force(c) && !is_constant(c); });
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
  } else if (moves_elsewhere) {
    finding.weight = Weight::kDoubt;
    finding.detail += "; it moves in another record, so this DOF stands still here or the sensor had failed";
  } else {
    finding.weight = Weight::kFault;
    finding.detail += ", and nothing else tells of this DOF: is the sensor connected, does the DOF move?";
  }
  return finding;
}

}  // namespace

std::vector<std::optional<Finding>> find_dead(const Record& record, const std::vector<bool>& moves_elsewhere) {
  std::vector<std::optional<Finding>> findings(record.channels.size());
  const std::vector<size_t> stops = stops_of(record);
  for (size_t i = 0; i < record.channels.size(); ++i) {
    const Channel& channel = record.channels[i];
    if (is_constant(channel)) findings[i] = finding_of(record, channel, moves_elsewhere[i]);
    if (stops[i] == 0) continue;
    std::string text =
        fmt::format("stops for good near {} s, while the other channels go on: did the sensor fail, or its cable?",
                    said_instant_s(record, static_cast<double>(stops[i])));
    findings[i] = Finding{"dead", Weight::kFault, channel.name, text, std::nullopt};
  }
  return findings;
}

}  // namespace host_sim::data_check
