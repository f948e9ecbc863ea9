#include "host_sim/data_check/measures/middle.hpp"

namespace host_sim::data_check {

const Record& middle_of(const Record& record, Record& part) {
  constexpr size_t kMostCompared = 1 << 17;  // enough to say, and no time lost
  if (record.samples() <= kMostCompared) return record;
  part.file = record.file;
  part.sample_period_s = record.sample_period_s;
  const size_t count = kMostCompared, first = (record.samples() - count) / 2;
  for (const Channel& channel : record.channels) {
    const auto begin = channel.values.begin() + static_cast<std::ptrdiff_t>(first);
    part.channels.push_back({channel.name, channel.quantity, channel.dof,
                             std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(count)),
                             channel.recorded_step, channel.held});
  }
  return part;
}

}  // namespace host_sim::data_check
