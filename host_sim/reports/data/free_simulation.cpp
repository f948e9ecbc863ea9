#include "host_sim/reports/data/free_simulation.hpp"

#include <algorithm>

#include "host_sim/plant/simulate.hpp"

namespace host_sim::reports {
namespace {

bool holds(const rig_file::Link& link) {
  const auto spring = [](const rig_file::Effect& effect) {
    return effect.kind == "cubic_stiffness" || effect.kind == "stiffness_error";
  };
  return link.stiffness_N_m.value > 0.0 || link.gravity_torque_N_m.value > 0.0 ||
         std::any_of(link.effects.begin(), link.effects.end(), spring);
}

}  // namespace

bool held_in_place(const rig_file::RigModel& rig) {
  std::vector<bool> held(rig.dofs.size(), false);
  const auto is_held = [&](int end) { return end <= 0 || held[static_cast<size_t>(end - 1)]; };
  for (size_t round = 0; round < rig.dofs.size(); ++round) {
    for (const rig_file::Link& link : rig.links) {
      if (!holds(link)) continue;
      if (is_held(link.b)) held[static_cast<size_t>(link.a - 1)] = true;
      if (is_held(link.a) && link.b > 0) held[static_cast<size_t>(link.b - 1)] = true;
    }
  }
  return std::all_of(held.begin(), held.end(), [](bool each) { return each; });
}

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
