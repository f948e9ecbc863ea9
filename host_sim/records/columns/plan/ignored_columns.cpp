#include "host_sim/records/columns/plan/ignored_columns.hpp"

#include <algorithm>
#include <optional>

#include "host_sim/records/columns/units/units.hpp"

namespace host_sim {
namespace {

bool in_force(const Column& column) {
  const std::string unit = parts_of(column).unit;
  for (const Dimension dimension : {Dimension::kForce, Dimension::kTorque}) {
    const auto known = unit.empty() ? std::nullopt : find_unit(unit, dimension);
    if (known && known->dimension == dimension) return true;
  }
  return false;
}

// A file with columns in units of force of which none is read: what drives the rig is likely among them.
void note_unread_force(const rig_file::RigModel& model, const std::vector<Column>& columns, ColumnPlan& plan) {
  const bool reads = std::any_of(plan.uses.begin(), plan.uses.end(), [](const ColumnUse& use) {
    return use.kind == ColumnUse::Kind::kChannel && use.channel.quantity == Quantity::kForce;
  });
  for (size_t i = 0; i < columns.size() && !reads; ++i) {
    if (plan.uses[i].kind != ColumnUse::Kind::kIgnored || !in_force(columns[i])) continue;
    const bool turns = !model.dofs.empty() && model.dofs.front().rotating;
    plan.notes.push_back("no force is read, and " + quoted_head(columns[i]) +
                         " is in a unit of force; if it drives the rig: --column " +
                         (turns ? "torque_1=" : "force_1=") + quoted_head(columns[i]));
    return;
  }
}

}  // namespace

void note_ignored(const rig_file::RigModel& model, const std::vector<Column>& columns, ColumnPlan& plan) {
  std::vector<Column> ignored;
  for (size_t i = 0; i < columns.size(); ++i)
    if (plan.uses[i].kind == ColumnUse::Kind::kIgnored && !trimmed_text(columns[i].head).empty())
      ignored.push_back(columns[i]);
  if (!ignored.empty()) plan.notes.push_back("ignored: " + quoted_heads(ignored));
  note_unread_force(model, columns, plan);
}

}  // namespace host_sim
