// The rig file's own terms, as a model.
#include "hal/rig_file/toml/effect_words.hpp"
#include "start.hpp"

namespace diagnosis::runs {
namespace {

void require_scale(const Model& model, const std::vector<Prepared>& records) {
  bool known = false, forced = false;
  for (const ModelTerm& t : model) known = known || (t.known && t.value != 0);
  for (const Prepared& p : records)
    for (const Vec& f : p.force) forced = forced || f.size() > 0;
  if (known || forced) return;
  throw CannotAnswer(
      "without a force and without one known coefficient the equations only determine ratios: state one mass (or "
      "inertia), "
      "for example 1, and read every other coefficient per unit of it");
}

// What the rig file does not give is not there.
void add(const Term& term, const rig_file::Coefficient& c, Model& model) {
  if (!c.estimate && c.value == 0) return;
  ModelTerm t;
  t.term = term, t.known = !c.estimate, t.value = c.estimate ? 0 : c.value;
  model.push_back(t);
}

void add_dof(const rig_file::Dof& given, int dof, Model& model) {
  add(on_dof(Kind::kMass, dof), given.mass_kg, model);
  for (const rig_file::Effect& e : given.effects) {
    Term term = on_dof(Kind::kMass, dof);
    if (!kind_of_word(e.kind, &term.kind)) continue;
    term.given = true;
    term.shape = rig_file::shape_of(e, 0, given.rotating), term.shape2 = rig_file::shape_of(e, 1, given.rotating);
    add(term, e.coefficient, model);
  }
}

void add_link(const rig_file::Link& given, int link, bool rotates, Model& model) {
  add(on_link(Kind::kStiffness, link), given.stiffness_N_m, model);
  add(on_link(Kind::kViscous, link), given.viscous_N_s_m, model);
  add(on_link(Kind::kCoulomb, link), given.coulomb_N, model);
  add(on_link(Kind::kGravity, link), given.gravity_torque_N_m, model);
  for (const rig_file::Effect& e : given.effects) {
    Term term = on_link(Kind::kStiffness, link);
    if (!kind_of_word(e.kind, &term.kind)) continue;
    term.given = true;
    term.shape = rig_file::shape_of(e, 0, rotates);
    if (term.kind == Kind::kCogging || term.kind == Kind::kPresliding) term.shape2 = rig_file::shape_of(e, 1, rotates);
    add(term, e.coefficient, model);
  }
}

}  // namespace

Model rig_as_given(const System& s, const std::vector<Prepared>& records) {
  Model model;
  for (size_t i = 0; i < s.dofs(); ++i) add_dof(s.rig.dofs[i], static_cast<int>(i), model);
  for (size_t l = 0; l < s.known_links; ++l)
    add_link(s.links[l], static_cast<int>(l), rig_file::link_rotates(s.rig, s.links[l]), model);
  require_scale(model, records);
  return model;
}

}  // namespace diagnosis::runs
