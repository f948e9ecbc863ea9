#include "host_sim/data_check/flat/frozen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace host_sim::data_check {
namespace {

constexpr double kByChance = 1e-6;  // of a record
constexpr double kSteps =
    2;  // of resolution, that the noise is: every seventh pair of neighbours is equal then, no more
constexpr double kGoesOn = 0.1;  // of the mean square of its steps: Gaussian motion over three periods seldom has less
constexpr double kFault = 0.01;  // of the record: energies are off by as much

// The longest run of one value; of none where every two neighbours differ.
Run longest_run(const std::vector<double>& values) {
  Run longest;
  for (const Run& run : equal_runs(values, 3))
    if (run.length > longest.length) longest = run;
  return longest;
}

// Whether chance brings such a run, with as many equal neighbours as the rest of the channel has.
bool by_chance(const std::vector<double>& values, const Run& run) {
  const auto count = static_cast<double>(values.size()), length = static_cast<double>(run.length);
  double equal = 0.0;
  for (size_t i = 1; i < values.size(); ++i) equal += values[i] == values[i - 1] ? 1.0 : 0.0;
  const double share = std::max(1.0, equal - (length - 1.0)) / std::max(1.0, count - length);
  return count * std::pow(std::min(1.0, share), length - 1.0) > kByChance;
}

// By steps over an eighth of the run: slower than noise.
bool others_go_on(const Record& record, size_t which, const Run& run) {
  const size_t lag = std::max<size_t>(1, run.length / 8);
  bool any = false;
  for (size_t i = 0; i < record.channels.size(); ++i) {
    const std::vector<double>& values = record.channels[i].values;
    const double usual = mean_square_step(values, 0, values.size(), lag);
    if (i == which || !(usual > 0.0)) continue;
    if (mean_square_step(values, run.first, run.first + run.length, lag) < kGoesOn * usual) return false;
    any = true;
  }
  return any;
}

}  // namespace

std::vector<Finding> find_frozen(const Record& record, const std::vector<Statistics>& statistics) {
  std::vector<Finding> findings;
  for (size_t i = 0; i < record.channels.size(); ++i) {
    const Channel& channel = record.channels[i];
    if (!statistics[i].noisy || statistics[i].noise < kSteps * statistics[i].resolution) continue;
    const Run run = longest_run(channel.values);
    if (run.length < 3 || by_chance(channel.values, run) || !others_go_on(record, i, run)) continue;
    const double value = channel.values[run.first];
    if (value == statistics[i].lowest || value == statistics[i].highest) continue;  // clipped
    const auto share = static_cast<double>(run.length) / static_cast<double>(channel.values.size());
    findings.push_back(
        {"dead", share < kFault ? Weight::kDoubt : Weight::kFault, channel.name,
         fmt::format("stands still at {:.6g} for {} samples from {} s on, while the other channels go on: did the "
                     "sensor fail, or its cable?",
                     value, run.length, said_instant_s(record, static_cast<double>(run.first))),
         std::nullopt});
  }
  return findings;
}

}  // namespace host_sim::data_check
