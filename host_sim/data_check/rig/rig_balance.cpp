#include "host_sim/data_check/rig/rig_balance.hpp"

#include <algorithm>

#include "host_sim/data_check/rig/balance.hpp"
#include "host_sim/data_check/rig/changes.hpp"
#include "host_sim/data_check/rig/exchanged_dofs.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kFewestBells = 60.0;  // in a record

}  // namespace

std::vector<Finding> check_rig_balance(const Record& record, const rig_file::RigModel& model) {
  Balance balance(record, model);
  std::vector<Change> possible = changes_of(balance.channels()), best;
  double best_before = 0.0, best_left = 1e300;
  size_t best_h = 0;
  for (size_t h = 2; static_cast<double>(record.samples()) > kFewestBells * static_cast<double>(6 * h); h *= 2) {
    const std::vector<Equation> equations = balance.equations(h);
    if (equations.empty()) continue;
    std::vector<Change> changes = possible;
    const double before = unexplained(equations, std::vector<double>(balance.channels().size(), 1.0));
    double least = before;
    for (Change& change : changes) {
      change.left = unexplained(equations, multipliers(balance.channels().size(), change));
      least = std::min(least, change.left);
    }
    if (least >= best_left) continue;
    best_left = least;
    best_before = before;
    best_h = h;
    best = std::move(changes);
  }
  if (best.empty()) return {};
  std::vector<Finding> findings = findings_of(std::move(best), balance.channels(), best_before);
  return findings.empty() ? exchanged_dofs(record, model, best_h, best_before) : findings;
}

}  // namespace host_sim::data_check
