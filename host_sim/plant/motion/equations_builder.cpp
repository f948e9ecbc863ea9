// From a rig in memory to the flat tables of Equations.
#include <algorithm>
#include <cmath>

#include "hal/rig_file/toml/effect_words.hpp"
#include "host_sim/plant/motion/equations.hpp"
#include "host_sim/plant/plant_error.hpp"

namespace host_sim {
namespace {

using firmware::EffectKind;
using firmware::EffectPlace;

double known(const rig_file::Coefficient& coefficient, const std::string& name) {
  if (coefficient.estimate)
    throw PlantError(name +
                     " is \"estimate\": a simulation needs a number (give it under [truth] or estimate it first)");
  if (!std::isfinite(coefficient.value)) throw PlantError(name + " is not finite, expected a number");
  return coefficient.value;
}

// In the order of the row; a key of the other kind of DOF, or of another unit, is not found.
vocabulary::Shape shape_of(const rig_file::Effect& effect, const firmware::EffectRow& row, const std::string& where,
                           bool rotating) {
  vocabulary::Shape shape;
  for (int i = 0; i < row.shape.count; ++i) {
    const std::string key = rig_file::shape_key(row, i, rotating);
    const firmware::ShapeParameter& parameter = row.shape.at[i];
    const auto found = effect.shape.find(key);
    if (found == effect.shape.end()) {
      if (parameter.may_be_left_out || parameter.zero_allowed) continue;
      throw PlantError(where + ": no key \"" + key + "\", expected the shape parameter of " + effect.kind);
    }
    if (found->second < 0.0 || (found->second == 0.0 && !parameter.zero_allowed))
      throw PlantError(where + ": " + key + " is " + std::to_string(found->second) + ", expected more than 0");
    shape.p[i] = found->second;
  }
  return shape;
}

}  // namespace

class EquationsBuilder {
 public:
  EquationsBuilder(const rig_file::RigModel& rig, Equations& target) : rig_(rig), target_(target) {}

  void build() {
    if (rig_.dofs.empty()) throw PlantError("rig has no [[dof]], expected at least one");
    for (size_t i = 0; i < rig_.dofs.size(); ++i) add_dof(i);
    for (const rig_file::Link& link : rig_.links) add_link(link);
    number_terms();
    target_.roots_ = 2 * target_.gaps_;
    for (const PlantLink& link : target_.links_) target_.roots_ += link.watch_rate ? 1 : 0;
  }

 private:
  using Terms = std::vector<PlantTerm>;

  void add_dof(size_t i) {
    const std::string label = "[" + std::to_string(i + 1) + "]";
    double mass = known(rig_.dofs[i].mass_kg, "mass" + label);
    Terms on_dof, on_drive;
    for (const rig_file::Effect& effect : rig_.dofs[i].effects) {
      const firmware::EffectRow& row = row_of(effect, label, EffectPlace::kDof);
      if (row.role == firmware::EffectRole::kCorrection)
        mass += known(effect.coefficient, effect.kind + label);
      else
        add_effect(effect, row, label, rig_.dofs[i].rotating,
                   row.role == firmware::EffectRole::kDriveFault ? on_drive : on_dof);
    }
    if (!(mass > 0.0))
      throw PlantError(
          "mass" + label + " is " + std::to_string(mass) +
          ": a DOF without inertia cannot move freely, expected more than 0 (records with imposed motion can "
          "be estimated, but not simulated)");
    target_.mass_.push_back(mass);
    target_.on_dof_.push_back(on_dof);
    target_.on_drive_.push_back(on_drive);
  }

  size_t node_of(int dof, const std::string& label) const {
    if (dof == rig_file::kGround) return target_.ground();
    if (dof == rig_file::kBase) return target_.base_node();
    if (dof >= 1 && static_cast<size_t>(dof) <= rig_.dofs.size()) return static_cast<size_t>(dof - 1);
    throw PlantError("link " + label + ": no DOF " + std::to_string(dof) + ", expected 1 to " +
                     std::to_string(rig_.dofs.size()));
  }

  void add_link(const rig_file::Link& source) {
    const std::string label =
        std::to_string(source.a) + "-" + (source.b == rig_file::kBase ? "base" : std::to_string(source.b));
    PlantLink link;
    link.a = node_of(source.a, label);
    link.b = node_of(source.b, label);
    if (link.a == link.b || (link.a >= target_.masses() && link.b >= target_.masses()))
      throw PlantError("link " + label +
                       " has no DOF that it could move, expected two different ends, one of them a DOF");
    const std::string place = "[" + label + "]";
    add_own(EffectKind::kStiffness, source.stiffness_N_m, place, link.terms);
    add_own(EffectKind::kViscous, source.viscous_N_s_m, place, link.terms);
    add_own(EffectKind::kCoulomb, source.coulomb_N, place, link.terms);
    add_own(EffectKind::kGravityTorque, source.gravity_torque_N_m, place, link.terms);
    for (const rig_file::Effect& effect : source.effects) {
      const firmware::EffectRow& row = row_of(effect, place, EffectPlace::kLink);
      if (row.role == firmware::EffectRole::kCorrection)
        own_term(row, link.terms).coefficient += known(effect.coefficient, effect.kind + place);
      else
        add_effect(effect, row, place, rig_file::link_rotates(rig_, source), link.terms);
    }
    link.terms.erase(std::remove_if(link.terms.begin(), link.terms.end(),
                                    [](const PlantTerm& term) { return term.coefficient == 0.0; }),
                     link.terms.end());
    for (const PlantTerm& term : link.terms) {
      const firmware::Nature& nature = firmware::row_of(term.kind).nature;
      link.hold += term.coefficient * vocabulary::hold_level(term.kind);
      link.watch_rate |= nature.events == firmware::Events::kRateZero;
    }
    target_.links_.push_back(link);
  }

  static const firmware::EffectRow& row_of(const rig_file::Effect& effect, const std::string& place,
                                           EffectPlace where) {
    const firmware::EffectRow* row = rig_file::find_effect_row(effect.kind);
    if (row == nullptr || !rig_file::stands_on(*row, where))
      throw PlantError(effect.kind + place + ": not an effect of a " + (where == EffectPlace::kDof ? "DOF" : "link") +
                       " that can be simulated");
    return *row;
  }

  static void add_own(EffectKind kind, const rig_file::Coefficient& coefficient, const std::string& place,
                      Terms& terms) {
    PlantTerm term;
    term.kind = kind;
    term.coefficient = known(coefficient, firmware::row_of(kind).word.text + place);
    terms.push_back(term);
  }

  // The rig file's own term that a row corrects: the one with the same column.
  static PlantTerm& own_term(const firmware::EffectRow& row, Terms& terms) {
    return *std::find_if(terms.begin(), terms.end(),
                         [&](const PlantTerm& term) { return term.kind == firmware::row_of(row.core.term).kind; });
  }

  static void add_effect(const rig_file::Effect& effect, const firmware::EffectRow& row, const std::string& place,
                         bool rotating, Terms& terms) {
    const std::string where = effect.kind + place;
    PlantTerm term;
    term.kind = row.kind;
    term.coefficient = known(effect.coefficient, where);
    term.shape = shape_of(effect, row, where, rotating);
    if (term.coefficient < 0.0 && row.nature.memory == firmware::Memory::kHiddenMass)
      throw PlantError(where + ": hidden mass is negative, expected more than 0");
    if (term.coefficient != 0.0) terms.push_back(term);
  }

  // Gaps and memories are numbered link by link, then DOF by DOF.
  void number_terms() {
    const auto number = [this](Terms& terms) {
      for (PlantTerm& term : terms) {
        if (firmware::row_of(term.kind).nature.events == firmware::Events::kGap) term.gap = target_.gaps_++;
        term.memory = target_.memory_of_.size();
        for (int m = 0; m < vocabulary::law_of(term.kind).memories; ++m) target_.memory_of_.push_back({term.kind, m});
      }
    };
    for (PlantLink& link : target_.links_) number(link.terms);
    for (size_t i = 0; i < target_.masses(); ++i) number(target_.on_dof_[i]), number(target_.on_drive_[i]);
  }

  const rig_file::RigModel& rig_;
  Equations& target_;
};

Equations::Equations(const rig_file::RigModel& rig) { EquationsBuilder(rig, *this).build(); }

}  // namespace host_sim
