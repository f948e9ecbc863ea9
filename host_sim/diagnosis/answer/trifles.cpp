#include "trifles.hpp"

#include <algorithm>
#include <cmath>

namespace diagnosis::runs {
namespace {

// What the cause's first number is an error of; 0: of nothing that is given.
double given(const System& system, const Cause& c) {
  if (c.effect == "sensor_gain") return 1;
  if (c.effect == "mass_error")
    for (size_t i = 0; i < system.dofs(); ++i)
      if (c.where == "dof " + std::to_string(i + 1)) return system.rig.dofs[i].mass_kg.value;
  if (c.effect == "stiffness_error")
    for (size_t l = 0; l < system.known_links; ++l)
      if (c.where == "link " + rig_file::link_label(system.links[l])) return system.links[l].stiffness_N_m.value;
  return 0;
}

}  // namespace

void drop_trifles(const Task& task, Diagnosis& d) {
  if (d.verdict == Verdict::kUnknown || d.causes.empty()) return;
  for (size_t i = 0; i < d.causes.size();) {
    const Cause& c = d.causes[i];
    const bool trifle =
        !c.parameters.empty() && std::abs(c.parameters[0].value) < kTrifle * std::abs(given(task.system, c));
    if (!trifle) {
      ++i;
      continue;
    }
    const std::string where = c.where;
    d.causes.erase(d.causes.begin() + static_cast<std::ptrdiff_t>(i));
    d.ambiguous_with.erase(std::remove_if(d.ambiguous_with.begin(), d.ambiguous_with.end(),
                                          [&](const NamedPlace& p) { return p.where == where; }),
                           d.ambiguous_with.end());
  }
  for (const Cause& c : d.causes)  // what is named is no alternative to itself
    d.ambiguous_with.erase(
        std::remove_if(d.ambiguous_with.begin(), d.ambiguous_with.end(),
                       [&](const NamedPlace& p) { return p.effect == c.effect && p.where == c.where; }),
        d.ambiguous_with.end());
  if (d.causes.empty()) d.ambiguous_with.clear();
  if (d.verdict == Verdict::kAmbiguous && d.ambiguous_with.empty()) d.verdict = Verdict::kExplained;
  if (d.causes.empty() && d.verdict == Verdict::kExplained) d.verdict = Verdict::kNone;
}

}  // namespace diagnosis::runs
