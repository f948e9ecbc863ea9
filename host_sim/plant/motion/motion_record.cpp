#include "host_sim/plant/motion/motion_record.hpp"

#include <algorithm>

#include "hal/rig_file/channel_name.hpp"

namespace host_sim {
namespace {

void add_channel(Record& record, Quantity quantity, int dof, bool rotating, size_t count) {
  record.channels.push_back({channel_name(quantity, dof, rotating), quantity, dof, std::vector<double>(count)});
}

}  // namespace

std::string channel_name(Quantity quantity, int dof, bool rotating) {
  return rig_file::format_channel_name({static_cast<firmware::Quantity>(quantity), dof, rotating});
}

bool uses_base(const rig_file::RigModel& rig) {
  return std::any_of(rig.links.begin(), rig.links.end(),
                     [](const rig_file::Link& link) { return link.a == rig_file::kBase || link.b == rig_file::kBase; });
}

// Columns in the order in which store_row fills them.
Record motion_record(const rig_file::RigModel& rig, double period_s, double start_s, size_t count,
                     MotionColumns columns) {
  Record record;
  record.sample_period_s = period_s;
  record.start_s = start_s;
  for (size_t i = 0; i < rig.dofs.size(); ++i) {
    const int dof = static_cast<int>(i + 1);
    const bool rotating = rig.dofs[i].rotating;
    if (columns.forces) add_channel(record, Quantity::kForce, dof, rotating, count);
    for (Quantity q : {Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration})
      add_channel(record, q, dof, rotating, count);
  }
  const bool rotating = !rig.dofs.empty() && rig.dofs[0].rotating;
  if (columns.base)
    for (Quantity q : {Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration})
      add_channel(record, q, rig_file::kBase, rotating, count);
  return record;
}

void store_row(const Integrator& integrator, const Equations& equations, MotionColumns columns, size_t row,
               Record& record) {
  const std::vector<double>& y = integrator.state();
  const std::vector<double>& dy = integrator.derivative();
  size_t column = 0;
  const auto put = [&](double value) { record.channels[column++].values[row] = value; };
  for (size_t i = 0; i < equations.masses(); ++i) {
    if (columns.forces) put(integrator.forces()[i]);
    put(y[i]);
    put(y[equations.masses() + i]);
    put(dy[equations.masses() + i]);
  }
  if (!columns.base) return;
  put(integrator.base().value);
  put(integrator.base().rate);
  put(integrator.base().acceleration);
}

}  // namespace host_sim
