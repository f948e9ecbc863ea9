#include "host_sim/reports/data/free_simulation.hpp"

#include "host_sim/plant/simulate.hpp"

namespace host_sim::reports {

Record simulate_from(const rig_file::RigModel& rig, const Record& record, const std::vector<size_t>& starts) {
  Record whole;
  for (size_t i = 0; i < starts.size(); ++i) {
    const size_t end = i + 1 < starts.size() ? starts[i + 1] : record.samples();
    const Record part = free_run(rig, record, starts[i], measured_state(rig, record, starts[i]), end - starts[i]);
    if (whole.channels.empty()) {
      whole = part;
      continue;
    }
    for (size_t c = 0; c < whole.channels.size(); ++c)
      whole.channels[c].values.insert(whole.channels[c].values.end(), part.channels[c].values.begin(),
                                      part.channels[c].values.end());
  }
  return whole;
}

}  // namespace host_sim::reports
