// From a rig in memory to the flat tables of Equations.
#include <cmath>
#include <map>

#include "host_sim/plant/equations.hpp"
#include "host_sim/plant/plant_error.hpp"

namespace host_sim {

namespace {

constexpr double kTwoPi = 6.283185307179586476925;

double known(const rig_file::Coefficient& coefficient, const std::string& name) {
  if (coefficient.estimate)
    throw PlantError(name +
                     " is \"estimate\": a simulation needs a number (give it under [truth] or estimate it first)");
  if (!std::isfinite(coefficient.value)) throw PlantError(name + " is not finite, expected a number");
  return coefficient.value;
}

double shape_of(const rig_file::Effect& effect, const std::string& where, const char* key,
                const char* other_key = nullptr) {
  for (const auto& entry : effect.shape)
    for (const char* wanted : {key, other_key})
      if (wanted != nullptr && entry.first.compare(0, std::string(wanted).size(), wanted) == 0) {
        if (entry.second > 0.0) return entry.second;
        throw PlantError(where + ": " + entry.first + " is " + std::to_string(entry.second) + ", expected more than 0");
      }
  throw PlantError(where + ": no key \"" + key + "_...\", expected the shape parameter of " + effect.kind);
}

struct ShapeWord {
  TermShape shape;
  const char* key;  // begins the name of the shape parameter, null where there is none
  bool may_be_left_out = false;
};

const std::map<std::string, ShapeWord>& shape_words() {
  static const std::map<std::string, ShapeWord> words = {
      {"cubic_stiffness", {TermShape::kCubicStiffness, nullptr}},
      {"quadratic_stiffness", {TermShape::kQuadraticStiffness, nullptr}},
      {"backlash", {TermShape::kBacklash, "gap"}},
      {"end_stop", {TermShape::kEndStop, "gap"}},
      {"quadratic_damping", {TermShape::kQuadraticDamping, nullptr}},
      {"cubic_damping", {TermShape::kCubicDamping, nullptr}},
      {"stribeck", {TermShape::kStribeck, "stribeck_velocity"}},
      {"presliding_hysteresis", {TermShape::kPresliding, "presliding_length"}},
      {"force_offset", {TermShape::kForceOffset, nullptr}},
      {"asymmetric_viscous", {TermShape::kAsymmetricViscous, nullptr}},
      {"displacement_dependent_damping", {TermShape::kDisplacementDependent, nullptr}},
      {"drifting_viscous", {TermShape::kDrifting, "drift_time", true}},
  };
  return words;
}

}  // namespace

class EquationsBuilder {
 public:
  EquationsBuilder(const rig_file::RigModel& rig, Equations& target) : rig_(rig), target_(target) {}

  void build() {
    target_.dofs_ = rig_.dofs.size();
    if (rig_.dofs.empty()) throw PlantError("rig has no [[dof]], expected at least one");
    for (size_t i = 0; i < rig_.dofs.size(); ++i) add_dof(i);
    for (size_t i = 0; i < rig_.dofs.size(); ++i) add_hidden_masses(i);
    for (const rig_file::Link& link : rig_.links) add_link(link);
    for (const PlantLink& link : hidden_links_) target_.links_.push_back(link);
    target_.roots_ = 2 * target_.gaps_;
    for (const PlantLink& link : target_.links_) target_.roots_ += link.watch_rate ? 1 : 0;
  }

 private:
  void add_dof(size_t i) {
    const std::string label = "[" + std::to_string(i + 1) + "]";
    double mass = known(rig_.dofs[i].mass_kg, "mass" + label);
    for (const rig_file::Effect& effect : rig_.dofs[i].effects)
      if (effect.kind == "mass_error") mass += known(effect.coefficient, "mass_error" + label);
    if (!(mass > 0.0))
      throw PlantError(
          "mass" + label + " is " + std::to_string(mass) +
          ": a DOF without inertia cannot move freely, expected more than 0 (records with imposed motion can "
          "be estimated, but not simulated)");
    target_.mass_.push_back(mass);
  }

  void add_hidden_masses(size_t i) {
    for (const rig_file::Effect& effect : rig_.dofs[i].effects) {
      const std::string where = effect.kind + "[" + std::to_string(i + 1) + "]";
      if (effect.kind == "mass_error") continue;
      if (effect.kind != "unmodelled_resonance")
        throw PlantError(where + ": not an effect of a DOF, expected mass_error or unmodelled_resonance");
      const double mass = known(effect.coefficient, where);
      if (mass == 0.0) continue;
      if (mass < 0.0) throw PlantError(where + ": hidden mass is negative, expected more than 0");
      const double omega = kTwoPi * shape_of(effect, where, "resonance", "frequency");
      const auto ratio = effect.shape.find("damping_ratio");
      PlantLink link;
      link.a = target_.mass_.size();
      link.b = i;
      link.k = mass * omega * omega;
      link.c = 2.0 * (ratio == effect.shape.end() ? 0.0 : ratio->second) * mass * omega;
      target_.mass_.push_back(mass);
      hidden_links_.push_back(link);
    }
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
    link.k = known(source.stiffness_N_m, "stiffness[" + label + "]");
    link.c = known(source.viscous_N_s_m, "viscous[" + label + "]");
    link.coulomb = known(source.coulomb_N, "coulomb[" + label + "]");
    link.gravity = known(source.gravity_torque_N_m, "gravity_torque[" + label + "]");
    for (const rig_file::Effect& effect : source.effects) add_effect(effect, label, link);
    link.hold = link.coulomb;
    link.watch_rate = link.coulomb != 0.0;
    for (const EffectTerm& term : link.effects) {
      if (term.shape == TermShape::kStribeck) link.hold += term.coefficient;
      link.watch_rate |= term.shape == TermShape::kStribeck || term.shape == TermShape::kPresliding ||
                         term.shape == TermShape::kAsymmetricViscous || term.shape == TermShape::kQuadraticDamping;
    }
    target_.links_.push_back(link);
  }

  void add_effect(const rig_file::Effect& effect, const std::string& label, PlantLink& link) {
    const std::string where = effect.kind + "[" + label + "]";
    const double value = known(effect.coefficient, where);
    if (effect.kind == "stiffness_error") return void(link.k += value);
    if (effect.kind == "missing_viscous") return void(link.c += value);
    if (effect.kind == "missing_coulomb") return void(link.coulomb += value);
    const auto word = shape_words().find(effect.kind);
    if (word == shape_words().end()) throw PlantError(where + ": not an effect of a link that can be simulated");
    EffectTerm term;
    term.shape = word->second.shape;
    term.coefficient = value;
    const bool left_out = effect.shape.empty() && word->second.may_be_left_out;
    if (word->second.key != nullptr && !left_out) term.p = shape_of(effect, where, word->second.key);
    if (value == 0.0) return;
    if (term.shape == TermShape::kBacklash || term.shape == TermShape::kEndStop) term.index = target_.gaps_++;
    if (term.shape == TermShape::kPresliding) term.index = target_.presliding_++;
    link.effects.push_back(term);
  }

  const rig_file::RigModel& rig_;
  Equations& target_;
  std::vector<PlantLink> hidden_links_;
};

Equations::Equations(const rig_file::RigModel& rig) { EquationsBuilder(rig, *this).build(); }

}  // namespace host_sim
