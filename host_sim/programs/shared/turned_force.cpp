#include "host_sim/programs/shared/turned_force.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host_sim/programs/shared/any_force.hpp"

namespace host_sim {
namespace {

constexpr double kSure = 4.0;  // deviations: chance makes a right number so negative once in 30,000 times

bool is_open(const rig_file::Coefficient& c) { return c.estimate || c.value == 0.0; }

bool is_mass_or_spring(firmware::TermKind kind) {
  return kind == firmware::TermKind::kMass || kind == firmware::TermKind::kStiffness;
}

}  // namespace

bool may_be_turned(const rig_file::RigModel& rig, const std::vector<Record>& records) {
  const auto open_dof = [](const rig_file::Dof& dof) { return is_open(dof.mass_kg); };
  const auto open_link = [](const rig_file::Link& link) {
    return is_open(link.stiffness_N_m) && is_open(link.gravity_torque_N_m) && link.b != rig_file::kBase;
  };
  const auto unknown_mass = [](const rig_file::Dof& dof) { return dof.mass_kg.estimate; };
  return std::all_of(rig.dofs.begin(), rig.dofs.end(), open_dof) &&
         std::all_of(rig.links.begin(), rig.links.end(), open_link) &&
         std::any_of(rig.dofs.begin(), rig.dofs.end(), unknown_mass) && any_force(records);
}

bool says_turned(const EstimateResult& result) {
  bool any = false;
  for (const ParameterResult& p : result.parameters) {
    if (!is_mass_or_spring(p.info.kind)) continue;
    const bool mass = p.info.kind == firmware::TermKind::kMass;
    const double against = mass ? p.value + kSure * p.std : p.value - kSure * p.std;
    if (against > 0.0) return false;
    any = any || mass || p.value + kSure * p.std < 0.0;
  }
  return any;
}

std::string turn_forces(std::vector<Record>& records) {
  std::vector<std::string> names;
  for (Record& record : records)
    for (Channel& channel : record.channels) {
      if (channel.quantity != Quantity::kForce) continue;
      if (&record == &records.front()) names.push_back(channel.name);
      for (double& value : channel.values) value = -value;
    }
  return fmt::format(
      "{} {} turned over: every mass and spring came out below nought. The sign is changed here; change it in the "
      "recording, or put the sign right where it is measured",
      fmt::join(names, ", "), names.size() == 1 ? "is" : "are");
}

}  // namespace host_sim
