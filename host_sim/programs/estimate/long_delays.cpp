#include "host_sim/programs/estimate/long_delays.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hal/rig_file/channel_entry.hpp"

namespace host_sim {
namespace {

constexpr double kOfFilters = 3.0;  // sample periods

std::ptrdiff_t whole_samples(const rig_file::RigModel& model, const Channel& channel, double sample_period_s) {
  return std::lround(rig_file::stated_delay_s(model, channel.name) / sample_period_s);
}

bool any_is_long(const rig_file::RigModel& model, const Record& record) {
  return std::any_of(record.channels.begin(), record.channels.end(), [&](const Channel& channel) {
    return std::abs(rig_file::stated_delay_s(model, channel.name)) > kOfFilters * record.sample_period_s;
  });
}

// What a channel that is late by n samples says of an instant stands n samples further on.
void shift(const rig_file::RigModel& model, Record& record) {
  std::ptrdiff_t earliest = 0, latest = 0;
  for (const Channel& channel : record.channels) {
    const std::ptrdiff_t late = whole_samples(model, channel, record.sample_period_s);
    earliest = std::min(earliest, late), latest = std::max(latest, late);
  }
  const std::ptrdiff_t first = -earliest, end = static_cast<std::ptrdiff_t>(record.samples()) - latest;
  if (end - first < 2)
    throw std::runtime_error(fmt::format("{}: its {} samples are no longer than the delays that the rig file states",
                                         record.file, record.samples()));
  for (Channel& channel : record.channels) {
    const auto from = channel.values.begin() + whole_samples(model, channel, record.sample_period_s);
    channel.values = std::vector<double>(from + first, from + end);
  }
  record.start_s += static_cast<double>(first) * record.sample_period_s;
  if (record.left_out_before) *record.left_out_before += static_cast<size_t>(first);
}

}  // namespace

std::string take_out_long_delays(rig_file::RigModel& model, SharedRecords& records) {
  const std::vector<Record>& given = records.get();
  if (given.empty() || !any_is_long(model, given.front())) return "";
  for (Record& record : records.own()) shift(model, record);
  const Record& shifted = records.get().front();
  std::string told;
  for (const Channel& channel : shifted.channels) {
    const std::ptrdiff_t late = whole_samples(model, channel, shifted.sample_period_s);
    if (late == 0) continue;
    rig_file::entry_to_write(model, channel.name).delay_us -= 1e6 * static_cast<double>(late) * shifted.sample_period_s;
    told += fmt::format("{}{} is read {} samples {}", told.empty() ? "" : ", ", channel.name, std::abs(late),
                        late > 0 ? "later" : "earlier");
  }
  return told + ", as the rig file states its delay";
}

}  // namespace host_sim
