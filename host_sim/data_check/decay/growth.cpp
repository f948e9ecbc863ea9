#include "host_sim/data_check/decay/growth.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/data_check/decay/coasting.hpp"
#include "host_sim/data_check/measures/period.hpp"
#include "host_sim/data_check/measures/statistics.hpp"
#include "host_sim/records/record_checks.hpp"

namespace host_sim::data_check {
namespace {

constexpr size_t kParts = kGrowthParts;
constexpr double kMoves = 0.05;                // of the largest mean square: less may be noise about a rig at rest
constexpr double kEachTime = 1.5, kInAll = 4;  // of the mean square

}  // namespace

std::vector<double> mean_squares_of_tenths(const Channel& channel) {
  const std::vector<double>& y = channel.values;
  const bool about_zero = keeps_its_sign(channel);
  std::vector<double> list;
  for (size_t part = 0; part < kParts; ++part) {
    const auto from = y.begin() + static_cast<std::ptrdiff_t>(part * y.size() / kParts),
               to = y.begin() + static_cast<std::ptrdiff_t>((part + 1) * y.size() / kParts);
    const MeanAndRms of = mean_and_rms({from, to});
    list.push_back(of.rms * of.rms + (about_zero ? of.mean * of.mean : 0.0));
  }
  return list;
}

Growth growth_of(const std::vector<double>& squares) {
  const double least = kMoves * *std::max_element(squares.begin(), squares.end());
  Growth best;
  for (size_t from = 0; from + 2 < squares.size(); ++from) {
    if (squares[from] < least) continue;
    size_t to = from;
    while (to + 1 < squares.size() && squares[to + 1] > squares[to]) ++to;
    size_t steps = 0;  // each half as much again as the last one that counted
    double last = squares[from];
    for (size_t i = from + 1; i <= to; ++i)
      if (squares[i] > kEachTime * last) last = squares[i], ++steps;
    const double times = squares[to] / squares[from];
    if (steps >= 2 && times > kInAll && times > best.times) best = {from, to, times};
  }
  return best;
}

std::optional<Finding> find_growth(const Record& record) {
  const Channel* motion = nullptr;
  for (const Channel& channel : record.channels) {
    if (drives(channel)) return std::nullopt;
    if (motion != nullptr && channel.dof != motion->dof) return std::nullopt;  // energy may go from mass to mass
    if (channel.quantity != Quantity::kForce && motion == nullptr) motion = &channel;
  }
  if (motion == nullptr || record.samples() < 16 * kParts) return std::nullopt;
  if (!coasting_decays(record).empty())
    return std::nullopt;  // a motor's run-up is left out, and nothing grows behind it
  // the mean square of less than a period goes with where in the swing it is taken
  if (const double period = period_of(motion->values); period * kParts > static_cast<double>(record.samples()))
    return std::nullopt;
  const Growth growth = growth_of(mean_squares_of_tenths(*motion));
  if (growth.times == 0.0) return std::nullopt;
  const double part_s = static_cast<double>(record.samples()) * record.sample_period_s / kParts;
  return Finding{
      "work", Weight::kFault, motion->name,
      fmt::format("grows by itself: its mean square is {:.2g} times as large in the {:.3g} s from {} s on as in "
                  "those from {} s on, and no force is recorded: what drives the rig has to be in the file",
                  growth.times, part_s,
                  said_instant_s(record, static_cast<double>(growth.to * record.samples() / kParts)),
                  said_instant_s(record, static_cast<double>(growth.from * record.samples() / kParts))),
      growth.times};
}

}  // namespace host_sim::data_check
