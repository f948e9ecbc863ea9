#include "host_sim/data_check/channel/staircase.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host_sim/records/steps/updates.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kMisses = 0.01;  // of the rms: a phase of as much, which makes a damping ratio of half of it

// What a held value is off the motion, which goes on from one update to the next, over the channel's rms.
double missed(const Channel& channel, const Statistics& statistics, double rows) {
  const double square =
      mean_square_step(channel.values, 0, channel.values.size(), static_cast<size_t>(std::lround(rows)));
  return std::sqrt(square * (rows - 1.0) * (2.0 * rows - 1.0) / 6.0) / rows / statistics.rms;
}

}  // namespace

std::optional<Finding> find_staircase(const Record& record, const Channel& channel, const Statistics& statistics) {
  if (channel.quantity == Quantity::kForce || channel.held) return std::nullopt;
  const double rate_Hz = 1.0 / record.sample_period_s;
  const double rows =
      channel.update_s > 0.0 ? channel.update_s * rate_Hz : rows_per_update(channel.values, statistics.resolution);
  if (!(rows > 1.0) || !(statistics.rms > 0.0)) return std::nullopt;
  const std::string text = fmt::format(
      "holds each value over {:.2g} rows on the mean: its sensor updates about {:.3g} times a "
      "second and the rows come at {:.4g}. It reads late by half of that. Record it at its own rate, or leave repeated "
      "values blank in the file: --resample {:.4g} fills them from its own",
      rows, rate_Hz / rows, rate_Hz, rate_Hz);
  const Weight weight = missed(channel, statistics, rows) > kMisses ? Weight::kDoubt : Weight::kInforms;
  return Finding{"staircase", weight, channel.name, text, rows};
}

}  // namespace host_sim::data_check
