// Visits every coefficient of a rig in the order in which the core numbers them: the one place that states this order.
#pragma once
#include <string>

#include "hal/rig_file/effect_words.hpp"
#include "hal/rig_file/rig_model.hpp"

namespace rig_file {

struct CoefficientSite {
  firmware::TermKind kind = firmware::TermKind::kMass;
  bool in_core = true;
  bool dof_term = false;
  int place = 0;     // index of the DOF or link
  std::string name;  // "viscous[1-2]"
  std::string unit;
  double shape = 0.0;
};

// Visit is called as visit(const CoefficientSite&, coefficient); Model is RigModel or const RigModel.
template <typename Model, typename Visit>
void walk_coefficients(Model& model, Visit visit) {
  using firmware::TermKind;
  const auto effects = [&](auto& list, bool dof_term, int place, const std::string& label, bool rotating) {
    for (auto& effect : list) {
      const EffectWord* word = find_effect_word(effect.kind);
      if (word == nullptr) continue;  // the reader refuses these
      visit(CoefficientSite{word->term, word->in_core, dof_term, place, effect.kind + "[" + label + "]",
                            rotating ? word->rotating_unit : word->unit, first_shape(effect, rotating)},
            effect.coefficient);
    }
  };
  for (size_t i = 0; i < model.dofs.size(); ++i) {
    auto& dof = model.dofs[i];
    const int place = static_cast<int>(i);
    const std::string label = std::to_string(i + 1);
    visit(
        CoefficientSite{TermKind::kMass, true, true, place, "mass[" + label + "]", dof.rotating ? "kg m^2" : "kg", 0.0},
        dof.mass_kg);
    effects(dof.effects, true, place, label, dof.rotating);
  }
  for (size_t i = 0; i < model.links.size(); ++i) {
    auto& link = model.links[i];
    const int place = static_cast<int>(i);
    const std::string label = link_label(link);
    const bool rotates = link_rotates(model, link);
    const auto plain = [&](TermKind kind, const char* word, const char* unit, auto& coefficient) {
      visit(CoefficientSite{kind, true, false, place, word + ("[" + label + "]"), unit, 0.0}, coefficient);
    };
    plain(TermKind::kStiffness, "stiffness", rotates ? "N m/rad" : "N/m", link.stiffness_N_m);
    plain(TermKind::kViscous, "viscous", rotates ? "N m s/rad" : "N s/m", link.viscous_N_s_m);
    plain(TermKind::kCoulomb, "coulomb", rotates ? "N m" : "N", link.coulomb_N);
    plain(TermKind::kGravity, "gravity_torque", "N m", link.gravity_torque_N_m);
    effects(link.effects, false, place, label, rotates);
  }
}

}  // namespace rig_file
