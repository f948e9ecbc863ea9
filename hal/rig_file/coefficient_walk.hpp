// Visits every coefficient of a rig in the order in which the core numbers them: the one place that states this order.
#pragma once
#include <string>

#include "hal/rig_file/rig_model.hpp"
#include "hal/rig_file/toml/effect_words.hpp"

namespace rig_file {

struct CoefficientSite {
  const EffectRow* row = nullptr;  // of the vocabulary
  bool in_core = true;             // the core has a column for it, with these shapes
  bool dof_term = false;
  int place = 0;     // index of the DOF or link
  std::string name;  // "viscous[1-2]"
  std::string unit;
  double shape = 0.0, second_shape = 0.0;
  firmware::TermKind kind() const { return row->core.term; }
};

// Visit is called as visit(const CoefficientSite&, coefficient); Model is RigModel or const RigModel.
template <typename Model, typename Visit>
void walk_coefficients(Model& model, Visit visit) {
  using firmware::EffectKind;
  const auto site = [](const EffectRow& row, bool dof_term, int place, const std::string& label, bool rotating) {
    return CoefficientSite{
        &row, row.core.estimable, dof_term, place, row.word.text + ("[" + label + "]"), unit_of(row, rotating), 0.0,
        0.0};
  };
  const auto own = [&](EffectKind kind, bool dof_term, int place, const std::string& label, bool rotating,
                       auto& coefficient) {
    visit(site(firmware::row_of(kind), dof_term, place, label, rotating), coefficient);
  };
  const auto effects = [&](auto& list, bool dof_term, int place, const std::string& label, bool rotating) {
    for (auto& effect : list) {
      const EffectRow* row = find_effect_row(effect.kind);
      if (row == nullptr) continue;  // the reader refuses these
      CoefficientSite there = site(*row, dof_term, place, label, rotating);
      there.shape = shape_of(effect, 0, rotating), there.second_shape = shape_of(effect, 1, rotating);
      there.in_core = in_core(effect, rotating);
      visit(there, effect.coefficient);
    }
  };
  for (size_t i = 0; i < model.dofs.size(); ++i) {
    auto& dof = model.dofs[i];
    const int place = static_cast<int>(i);
    const std::string label = std::to_string(i + 1);
    own(EffectKind::kMass, true, place, label, dof.rotating, dof.mass_kg);
    effects(dof.effects, true, place, label, dof.rotating);
  }
  for (size_t i = 0; i < model.links.size(); ++i) {
    auto& link = model.links[i];
    const int place = static_cast<int>(i);
    const std::string label = link_label(link);
    const bool rotates = link_rotates(model, link);
    own(EffectKind::kStiffness, false, place, label, rotates, link.stiffness_N_m);
    own(EffectKind::kViscous, false, place, label, rotates, link.viscous_N_s_m);
    own(EffectKind::kCoulomb, false, place, label, rotates, link.coulomb_N);
    own(EffectKind::kGravityTorque, false, place, label, rotates, link.gravity_torque_N_m);
    effects(link.effects, false, place, label, rotates);
  }
}

}  // namespace rig_file
