// The rig file's own terms.
#include "../search/candidates.hpp"
#include "hal/rig_file/toml/effect_words.hpp"

namespace diagnosis {

std::vector<ActiveTerm> base_model(const Rows& rows) {
  const System& s = rows.system();
  std::vector<ActiveTerm> model;
  const auto kind_of = [](const rig_file::Effect& e) {  // a force that the rig has must not be left out in silence
    Kind kind = Kind::kMass;
    if (!kind_of_word(e.kind, &kind))
      throw CannotAnswer("the diagnosis cannot take " + e.kind + " as given: leave it out of the rig file");
    return kind;
  };
  const auto add = [&](const Term& term, const rig_file::Coefficient& c, bool always) {
    if (!always && !c.estimate && c.value == 0) return;
    ActiveTerm t;
    Term own = term;
    own.smooth = c.estimate;
    t.term = own;
    t.column = rows.column(own);
    t.known = !c.estimate;
    t.value = c.estimate ? 0 : c.value;
    model.push_back(t);
  };
  for (size_t i = 0; i < s.dofs(); ++i) {
    add(on_dof(Kind::kMass, static_cast<int>(i)), s.rig.dofs[i].mass_kg, false);
    for (const rig_file::Effect& e : s.rig.dofs[i].effects) {
      Term term = on_dof(kind_of(e), static_cast<int>(i));
      term.given = true;
      if (e.shape.count("resonance_Hz")) term.shape = e.shape.at("resonance_Hz");
      if (e.shape.count("damping_ratio")) term.shape2 = e.shape.at("damping_ratio");
      add(term, e.coefficient, true);
    }
  }
  for (size_t l = 0; l < s.known_links; ++l) {
    const rig_file::Link& link = s.links[l];
    const int i = static_cast<int>(l);
    add(on_link(Kind::kStiffness, i), link.stiffness_N_m, false);
    add(on_link(Kind::kViscous, i), link.viscous_N_s_m, false);
    add(on_link(Kind::kCoulomb, i), link.coulomb_N, false);
    add(on_link(Kind::kGravity, i), link.gravity_torque_N_m, false);
    for (const rig_file::Effect& e : link.effects) {
      Term term = on_link(kind_of(e), i);
      term.given = true;
      term.shape = rig_file::shape_of(e, 0, rig_file::link_rotates(s.rig, link));
      add(term, e.coefficient, true);
    }
  }
  return model;
}

}  // namespace diagnosis
