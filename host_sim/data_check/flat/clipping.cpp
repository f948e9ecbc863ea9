#include "host_sim/data_check/flat/clipping.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host_sim/data_check/flat/flat_tops.hpp"

namespace host_sim::data_check {
namespace {

std::string said(const Tops& top, const Tops& bottom, size_t count, const Statistics& statistics) {
  const bool high = top.samples > 0, low = bottom.samples > 0;
  const double share = 100.0 * static_cast<double>(top.samples + bottom.samples) / static_cast<double>(count);
  const std::string where = high && low ? fmt::format("{:.4g} and {:.4g}", statistics.lowest, statistics.highest)
                                        : fmt::format("{:.4g}", high ? statistics.highest : statistics.lowest);
  return fmt::format(
      "flat at {} for {:.2g} % of the samples ({} times): its range ends there; lower the level or widen the range, "
      "then "
      "record again",
      where, share, top.runs + bottom.runs);
}

}  // namespace

std::vector<Run> clipped_runs(const Channel& channel, const Record& record) {
  FlatTops tops = flat_tops(channel, &record, statistics_of(channel), 0.0, 0.0);
  std::vector<Run> runs = std::move(tops.top.where);
  runs.insert(runs.end(), tops.bottom.where.begin(), tops.bottom.where.end());
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.first < b.first; });
  return runs;
}

std::optional<Finding> find_clipping(const Channel& channel, const Statistics& statistics, double lower_limit,
                                     double upper_limit, const Record* record) {
  const std::vector<double>& values = channel.values;
  const FlatTops tops = flat_tops(channel, record, statistics, lower_limit, upper_limit);
  const Tops &top = tops.top, &bottom = tops.bottom;
  if (top.samples + bottom.samples == 0) return std::nullopt;
  const double share = static_cast<double>(top.samples + bottom.samples) / static_cast<double>(values.size());
  Finding finding;
  finding.kind = "clipped";
  finding.channel = channel.name;
  finding.value = share;
  finding.detail = said(top, bottom, values.size(), statistics);
  // A smooth force that is cut may be the drive's own limit, truly measured.
  const bool perhaps_drive = channel.quantity == Quantity::kForce && !tops.amid_noise && !tops.at_limit;
  finding.weight = share >= kFaultShare && !perhaps_drive ? Weight::kFault : Weight::kDoubt;
  if (perhaps_drive) finding.detail += " (if the drive itself ends there and this is what acts, nothing is wrong)";
  return finding;
}

}  // namespace host_sim::data_check
