#include "host_sim/vocabulary/held_in_place.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "hal/rig_file/toml/effect_words.hpp"
#include "host_sim/vocabulary/law.hpp"

namespace vocabulary {
namespace {

// Of each column of the core the sum over a link's own term, its corrections and its effects; unknown ones count as 1.
using Sums = std::array<double, firmware::kTermKinds>;

void add(Sums& sums, const firmware::EffectRow& row, const rig_file::Coefficient& coefficient) {
  if (row.core.estimable) sums[static_cast<size_t>(row.core.term)] += coefficient.estimate ? 1.0 : coefficient.value;
}

bool holds(const rig_file::Link& link) {
  Sums sums{};
  add(sums, firmware::row_of(EffectKind::kStiffness), link.stiffness_N_m);
  add(sums, firmware::row_of(EffectKind::kGravityTorque), link.gravity_torque_N_m);
  for (const rig_file::Effect& effect : link.effects)
    if (const firmware::EffectRow* row = rig_file::find_effect_row(effect.kind)) add(sums, *row, effect.coefficient);
  for (size_t t = 0; t < sums.size(); ++t)
    if (sums[t] > 0.0 && pulls_back(firmware::row_of(static_cast<firmware::TermKind>(t)).kind)) return true;
  return false;
}

}  // namespace

bool pulls_back(EffectKind kind) {
  const firmware::EffectRow& row = firmware::row_of(kind);
  if (row.place != firmware::EffectPlace::kLink || !row.nature.conservative) return false;
  const Shape shape{{0.4, 0.3}};
  for (double u = -1.0; u <= 1.0; u += 0.0625)
    if (force(kind, point(kind, u, 0.0, 0.0, shape), shape).value * u < 0.0) return false;
  return force(kind, point(kind, 1.0, 0.0, 0.0, shape), shape).value > 0.0 &&
         force(kind, point(kind, -1.0, 0.0, 0.0, shape), shape).value < 0.0;
}

bool held_in_place(const rig_file::RigModel& rig) {
  std::vector<bool> held(rig.dofs.size(), false);
  const auto is_held = [&](int end) { return end <= 0 || held[static_cast<size_t>(end - 1)]; };
  for (size_t round = 0; round < rig.dofs.size(); ++round)
    for (const rig_file::Link& link : rig.links) {
      if (!holds(link)) continue;
      if (is_held(link.b)) held[static_cast<size_t>(link.a - 1)] = true;
      if (is_held(link.a) && link.b > 0) held[static_cast<size_t>(link.b - 1)] = true;
    }
  return std::all_of(held.begin(), held.end(), [](bool each) { return each; });
}

bool massless(const rig_file::RigModel& rig) {
  return std::all_of(rig.dofs.begin(), rig.dofs.end(),
                     [](const rig_file::Dof& d) { return !d.mass_kg.estimate && d.mass_kg.value == 0; });
}

}  // namespace vocabulary
