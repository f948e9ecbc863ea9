// The keys that the vocabulary's rows (firmware/vocabulary) have in a rig file, with their units.
#pragma once
#include <string>
#include <vector>

#include "firmware/vocabulary/effect_table.hpp"
#include "hal/rig_file/rig_model.hpp"

namespace rig_file {

using firmware::EffectPlace;
using firmware::EffectRow;

// The rows that stand in [[link.effect]] or [[dof.effect]] tables. A fault of a force channel's drive stands with its DOF.
std::vector<const EffectRow*> effect_rows(EffectPlace where);
const EffectRow* find_effect_row(const std::string& kind);  // nullptr: not a word of such tables
bool stands_on(const EffectRow& row, EffectPlace where);

// "N m/rad" as the end of a key: "_N_m_rad"; nothing for pure numbers.
std::string unit_suffix(const std::string& unit);
// Unit of the coefficient; of a row that stands on rotating links alone that one.
std::string unit_of(const EffectRow& row, bool rotating);
// "stiffness_N_m", "inertia_kg_m2"; empty where the row has no key on such a DOF.
std::string own_key(const EffectRow& row, bool rotating);
// "gap_m", or "gap_rad" on a rotating link; empty where the effect has no such key.
std::string shape_key(const EffectRow& row, int index, bool rotating);
// The shape parameters of an effect in the order of its row, 0 where it has none.
double shape_of(const Effect& effect, int index, bool rotating);
// The core has a column for it: the row has one, and none of the shapes is beyond it.
bool in_core(const Effect& effect, bool rotating);

}  // namespace rig_file
