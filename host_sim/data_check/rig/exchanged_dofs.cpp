#include "host_sim/data_check/rig/exchanged_dofs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host_sim/data_check/rig/balance.hpp"
#include "host_sim/data_check/rig/changes.hpp"

namespace host_sim::data_check {
namespace {

// The record with the motion channels of two DOFs exchanged.
Record with_exchanged(const Record& record, int i, int j) {
  Record other = record;
  for (Channel& channel : other.channels) {
    if (channel.quantity == Quantity::kForce || (channel.dof != i && channel.dof != j)) continue;
    channel.values = record.find(channel.quantity, channel.dof == i ? j : i)->values;
  }
  return other;
}

// Both DOFs have one motion channel, of one quantity. (Several channels of a DOF that all went to the other are less
// likely than a rig file that lacks something; one of several is told by its fellows, between_dofs/exchanged.hpp.)
bool can_be_exchanged(const Record& record, int i, int j) {
  const Channel *of_i = nullptr, *of_j = nullptr;
  for (const Channel& channel : record.channels) {
    if (channel.quantity == Quantity::kForce || (channel.dof != i && channel.dof != j)) continue;
    const Channel*& place = channel.dof == i ? of_i : of_j;
    if (place != nullptr) return false;
    place = &channel;
  }
  return of_i != nullptr && of_j != nullptr && dimension_of_channel(*of_i) == dimension_of_channel(*of_j);
}

}  // namespace

std::vector<Finding> exchanged_dofs(const Record& record, const rig_file::RigModel& model, size_t h, double before) {
  if (!(before > kUnexplained)) return {};
  int best_i = 0, best_j = 0;
  double best = 1e300, next = 1e300;
  const int dofs = static_cast<int>(model.dofs.size());
  for (int i = 1; i <= dofs; ++i)
    for (int j = i + 1; j <= dofs; ++j) {
      if (!can_be_exchanged(record, i, j)) continue;
      const Record other = with_exchanged(record, i, j);
      Balance balance(other, model);
      const std::vector<Equation> equations = balance.equations(h);
      if (equations.empty()) continue;
      const double left = unexplained(equations, std::vector<double>(balance.channels().size(), 1.0));
      next = std::min(next, std::max(left, best));
      if (left < best) best = left, best_i = i, best_j = j;
    }
  if (!(best < kExplained) || !(best < 0.25 * before) || next < kRivals * best) return {};
  std::vector<Finding> findings;
  for (const Channel& channel : record.channels) {
    if (channel.quantity == Quantity::kForce || channel.dof != best_i) continue;
    std::string text = fmt::format(
        ": the rig file's masses and springs explain {:.0f} % of the motion so, and {:.0f} % as it stands; exchange "
        "the columns, or the DOFs' numbers in the rig file",
        100.0 * (1.0 - best), 100.0 * std::max(0.0, 1.0 - before));
    findings.push_back({"exchanged", Weight::kFault, channel.name,
                        "is exchanged with " + record.find(channel.quantity, best_j)->name + text, best});
  }
  return findings;
}

}  // namespace host_sim::data_check
