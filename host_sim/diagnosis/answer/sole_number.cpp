#include "sole_number.hpp"

#include <algorithm>

#include "../fit/start.hpp"
#include "../terms/naming.hpp"

namespace diagnosis::runs {
namespace {

// The DOF whose force alone drives the rig, from 0; -1: none, several, or a base that moves.
int sole_drive(const Prepared& record) {
  int dof = -1;
  if (record.guess.back().given) return dof;
  for (size_t i = 0; i < record.force.size(); ++i) {
    if (record.force[i].size() == 0) continue;
    if (dof >= 0) return -1;
    dof = static_cast<int>(i);
  }
  return dof;
}

NamedPlace named(const System& system, const Term& t) { return {word_of(t.kind), place_of(system, t, {})}; }

bool same(const Cause& c, const NamedPlace& p) { return c.effect == p.effect && c.where == p.where; }

}  // namespace

void say_sole_number(const Task& task, Diagnosis& d) {
  const int drive = sole_drive(task.records[0]);
  if (drive < 0 || d.causes.size() != 1) return;
  const Model rig = rig_as_given(task.system, task.records);
  const auto is_known = [](const ModelTerm& t) { return t.known; };
  const auto known = std::find_if(rig.begin(), rig.end(), is_known);
  if (std::count_if(rig.begin(), rig.end(), is_known) != 1) return;
  const Term& number = known->term;
  if (number.kind != Kind::kMass && number.kind != Kind::kStiffness) return;
  const NamedPlace error = named(task.system, number.kind == Kind::kMass ? on_dof(Kind::kMassError, number.dof)
                                                                         : on_link(Kind::kStiffnessError, number.link)),
                   gain = named(task.system, on_dof(Kind::kForceGain, drive));
  const Cause& cause = d.causes[0];
  if (!same(cause, error) && !same(cause, gain)) return;
  const NamedPlace& other = same(cause, gain) ? error : gain;
  if (std::find(d.ambiguous_with.begin(), d.ambiguous_with.end(), other) == d.ambiguous_with.end())
    d.ambiguous_with.push_back(other);
  d.verdict = Verdict::kAmbiguous;
}

}  // namespace diagnosis::runs
