#include "host_sim/data_check/rig/exchanged_dofs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "host_sim/data_check/rig/balance.hpp"
#include "host_sim/data_check/rig/changes.hpp"

namespace host_sim::data_check {
namespace {

enum class What { kMotion, kForces, kBoth };

struct Exchange {
  What what;
  int i, j;  // i < j
  double left;
};

bool takes(What what, const Channel& channel) {
  if (what == What::kBoth) return true;
  return (channel.quantity == Quantity::kForce) == (what == What::kForces);
}

Record with_exchanged(const Record& record, const Exchange& exchange) {
  Record other = record;
  for (Channel& channel : other.channels)
    if (takes(exchange.what, channel) && (channel.dof == exchange.i || channel.dof == exchange.j))
      channel.dof = exchange.i + exchange.j - channel.dof;
  return other;
}

using Sensors = std::set<std::pair<Quantity, Dimension>>;

Sensors motion_of(const Record& record, int dof) {
  Sensors sensors;
  for (const Channel& channel : record.channels)
    if (channel.dof == dof && channel.quantity != Quantity::kForce)
      sensors.insert({channel.quantity, dimension_of_channel(channel)});
  return sensors;
}

bool can_be_exchanged(const Record& record, const rig_file::RigModel& model, What what, int i, int j) {
  const bool forces = record.find(Quantity::kForce, i) != nullptr || record.find(Quantity::kForce, j) != nullptr;
  const bool alike = model.dofs[static_cast<size_t>(i - 1)].rotating == model.dofs[static_cast<size_t>(j - 1)].rotating;
  if (what != What::kMotion && !(forces && alike)) return false;
  const Sensors motion = motion_of(record, i);
  return what == What::kForces || (!motion.empty() && motion == motion_of(record, j));
}

// 0 where the exchange hides what it should explain, and so cannot be excluded: fewer equations tell something then, or none has a force that drives.
double left_by(const Exchange& exchange, const Record& record, const rig_file::RigModel& model, size_t h,
               size_t equations_before) {
  constexpr double kHides = 0.0;  // it may be right
  const Record other = with_exchanged(record, exchange);
  Balance balance(other, model);
  const std::vector<Equation> equations = balance.equations(h);
  if (equations.empty() || equations.size() < equations_before) return kHides;
  for (size_t c = 0; c < balance.channels().size() && exchange.what != What::kMotion; ++c) {
    const Channel& force = *balance.channels()[c];
    const bool moved = force.quantity == Quantity::kForce && (force.dof == exchange.i || force.dof == exchange.j);
    if (moved && std::none_of(equations.begin(), equations.end(),
                              [c](const Equation& equation) { return equation.reference_channel == c; }))
      return kHides;
  }
  return unexplained(equations, std::vector<double>(balance.channels().size(), 1.0));
}

std::string of_force(const Channel& force, const Exchange& e, const Channel* fellow) {
  return fellow != nullptr ? "is exchanged with " + fellow->name
                           : fmt::format("acts on DOF {}, not on DOF {}", e.i + e.j - force.dof, force.dof);
}

std::string of_motion(const Exchange& e, const Channel& fellow, bool alone) {
  std::string text = "is exchanged with " + fellow.name;
  if (e.what == What::kBoth || !alone)
    text += fmt::format(" (all channels of DOF {} and DOF {} are exchanged{})", e.i, e.j,
                        e.what == What::kBoth ? ", forces too" : "");
  return text;
}

std::vector<Finding> findings_of(const Record& record, const Exchange& best, double before) {
  const std::string text =
      fmt::format(": the rig file's masses and springs explain {:.0f} % of the motion so, and {:.0f} % as it stands; ",
                  100.0 * (1.0 - best.left), 100.0 * std::max(0.0, 1.0 - before));
  std::vector<Finding> findings;
  const auto add = [&](const Channel& channel, const std::string& what, const char* remedy) {
    findings.push_back({"exchanged", Weight::kFault, channel.name, what + text + remedy, best.left});
  };
  for (const Channel& channel : record.channels) {
    if (!takes(best.what, channel) || (channel.dof != best.i && channel.dof != best.j)) continue;
    const Channel* fellow = record.find(channel.quantity, best.i + best.j - channel.dof);
    if (channel.quantity == Quantity::kForce && best.what == What::kForces &&
        (fellow == nullptr || channel.dof == best.i))
      add(channel, of_force(channel, best, fellow), "give it the number of the DOF that it drives");
    if (channel.quantity != Quantity::kForce && fellow != nullptr && channel.dof == best.i)
      add(channel, of_motion(best, *fellow, motion_of(record, best.i).size() == 1),
          "exchange the columns, or the DOFs' numbers in the rig file");
  }
  return findings;
}

}  // namespace

std::vector<Finding> exchanged_dofs(const Record& record, const rig_file::RigModel& model, size_t h, double before) {
  if (!(before > kUnexplained)) return {};
  const size_t equations_before = Balance(record, model).equations(h).size();
  std::vector<Exchange> tried;
  const int dofs = static_cast<int>(model.dofs.size());
  for (int i = 1; i <= dofs; ++i)
    for (int j = i + 1; j <= dofs; ++j)
      for (const What what : {What::kMotion, What::kForces, What::kBoth})
        if (can_be_exchanged(record, model, what, i, j)) {
          tried.push_back({what, i, j, 0.0});
          tried.back().left = left_by(tried.back(), record, model, h, equations_before);
        }
  if (tried.empty()) return {};
  std::stable_sort(tried.begin(), tried.end(), [](const Exchange& a, const Exchange& b) { return a.left < b.left; });
  const Exchange& best = tried.front();
  if (!(best.left > 0.0) || !(best.left < kExplained) || !(best.left < 0.25 * before)) return {};
  if (tried.size() > 1 && tried[1].left < kRivals * best.left) return {};
  return findings_of(record, best, before);
}

}  // namespace host_sim::data_check
