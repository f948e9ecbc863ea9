#include "host_sim/records/stretch.hpp"

namespace host_sim {
namespace {

void keep(size_t first, size_t end, std::vector<double>& values) {
  values.resize(end);
  values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(first));
}

}  // namespace

Record stretch_of(Record record, size_t first, size_t end) {
  for (Channel& channel : record.channels) keep(first, end, channel.values);
  if (record.time_s.empty())
    record.start_s += static_cast<double>(first) * record.sample_period_s;
  else
    keep(first, end, record.time_s);
  if (record.left_out_before) *record.left_out_before += first;
  return record;
}

}  // namespace host_sim
