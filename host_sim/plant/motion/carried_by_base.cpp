#include "host_sim/plant/motion/carried_by_base.hpp"

#include <algorithm>

#include "host_sim/plant/motion/motion_record.hpp"

namespace host_sim {

bool carried_by_base(const rig_file::RigModel& rig, const Record& record) {
  const auto at = [](const rig_file::Link& link, int end) { return link.a == end || link.b == end; };
  const auto on = [&](int end) {
    return std::any_of(rig.links.begin(), rig.links.end(), [&](const rig_file::Link& l) { return at(l, end); });
  };
  const auto acceleration_or_force = [](const Channel& c) {
    return c.quantity == Quantity::kAcceleration || c.quantity == Quantity::kForce;
  };
  return on(rig_file::kBase) && !on(rig_file::kGround) &&
         record.find(Quantity::kAcceleration, rig_file::kBase) != nullptr &&
         std::all_of(record.channels.begin(), record.channels.end(), acceleration_or_force);
}

rig_file::RigModel seen_from_base(const rig_file::RigModel& rig) {
  rig_file::RigModel seen = rig;
  for (rig_file::Link& link : seen.links)
    for (int* end : {&link.a, &link.b})
      if (*end == rig_file::kBase) *end = rig_file::kGround;
  return seen;
}

Record with_inertial_forces(const rig_file::RigModel& rig, const Record& record) {
  const Channel& base = *record.find(Quantity::kAcceleration, rig_file::kBase);
  Record seen = record;
  seen.channels.clear();
  for (size_t i = 0; i < rig.dofs.size(); ++i) {
    const int dof = static_cast<int>(i + 1);
    const Channel* given = record.find(Quantity::kForce, dof);
    Channel force{channel_name(Quantity::kForce, dof, rig.dofs[i].rotating), Quantity::kForce, dof, {}};
    force.values = given != nullptr ? given->values : std::vector<double>(record.samples(), 0.0);
    for (size_t k = 0; k < force.values.size(); ++k) force.values[k] -= rig.dofs[i].mass_kg.value * base.values[k];
    seen.channels.push_back(std::move(force));
  }
  return seen;
}

}  // namespace host_sim
