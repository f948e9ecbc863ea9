#include "naming.hpp"

#include <algorithm>
#include <cmath>

#include "hal/rig_file/channel_entry.hpp"
#include "hal/rig_file/toml/effect_words.hpp"

namespace diagnosis {
namespace {

rig_file::Effect as_effect(const Term& t, double value, bool rotating) {
  rig_file::Effect e;
  e.kind = word_of(t.kind);
  // a rig file's backlash takes its coefficient away inside the gap: as large as the stiffness, and known with it
  const bool linear = t.kind != Kind::kBacklash && t.kind != Kind::kResonance;
  e.coefficient = {t.kind == Kind::kBacklash ? -value : value, linear};
  const firmware::EffectRow* word = rig_file::find_effect_row(e.kind);
  if (word == nullptr) return e;
  const double shapes[] = {t.shape, t.shape2};
  for (int i = 0; i < 2; ++i) {
    const std::string key = rig_file::shape_key(*word, i, rotating);
    if (!key.empty() && (shapes[i] > 0 || t.kind == Kind::kResonance || (i == 1 && t.kind == Kind::kCogging)))
      e.shape[key] = shapes[i];
  }
  // what the core cannot estimate stands with its value: the file is read by all commands, and the effect is known
  e.coefficient.estimate = e.coefficient.estimate && rig_file::in_core(e, rotating);
  return e;
}

// A hum's amplitude: of its cosine and of the sine that goes with it.
double amplitude(const std::vector<ActiveTerm>& model, const ActiveTerm& cosine) {
  double square = cosine.value * cosine.value;
  for (const ActiveTerm& a : model)
    if (a.companion >= 0 && model[static_cast<size_t>(a.companion)].term.same_place(cosine.term))
      square += a.value * a.value;
  return std::sqrt(square);
}

}  // namespace

std::string force_channel(const rig_file::RigModel& rig, size_t dof) {
  const std::string number = std::to_string(dof + 1);
  return rig.dofs[dof].rotating ? "torque_" + number + "_N_m" : "force_" + number + "_N";
}

std::string place_of(const System& s, const Term& t, const FusedRecord& f) {
  (void)f;
  if (t.link >= 0) return "link " + rig_file::link_label(s.links[static_cast<size_t>(t.link)]);
  if (of_force_sensor(t.kind)) return "channel " + force_channel(s.rig, static_cast<size_t>(t.dof));
  return "dof " + std::to_string(t.dof + 1);
}

bool rotates(const System& s, const Term& t) {
  if (t.link >= 0) return rig_file::link_rotates(s.rig, s.links[static_cast<size_t>(t.link)]);
  return s.rig.dofs[static_cast<size_t>(t.dof)].rotating;
}

std::string unit_of(Kind kind, bool rotating) {
  const std::string unit = firmware::row_of(effect_of(kind)).unit.of(rotating);
  return unit != "channel" ? unit : rotating ? "N m" : "N";  // of a force's channel
}

std::string shape_name(Kind kind) {
  const firmware::Shapes& shapes = firmware::row_of(effect_of(kind)).shape;
  return shapes.count > 0 ? shapes.at[0].name : "";
}

std::string shape_unit(Kind kind, bool rotating) {
  const firmware::Shapes& shapes = firmware::row_of(effect_of(kind)).shape;
  return shapes.count > 0 ? shapes.at[0].unit.of(rotating) : "1";
}

std::string parameter_name(const System& s, const Term& t) {
  if (t.link >= 0)
    return std::string(word_of(t.kind)) + "[" + rig_file::link_label(s.links[static_cast<size_t>(t.link)]) + "]";
  return std::string(word_of(t.kind)) + "[" + std::to_string(t.dof + 1) + "]";
}

std::vector<Parameter> parameters_of_term(const System& s, const std::vector<ActiveTerm>& model, const ActiveTerm& a) {
  const Term& t = a.term;
  const bool turning = rotates(s, t);
  const std::string name = parameter_name(s, t);
  double reading = 1;  // true force per reading: the model corrects the reading, a fault is of the true force
  for (const ActiveTerm& g : model)
    if (g.term.kind == Kind::kForceGain && g.term.dof == t.dof && of_force_sensor(t.kind)) reading -= g.value;
  const bool hum = t.kind == Kind::kForceHumCos50 || t.kind == Kind::kForceHumCos60;
  const double value = hum ? amplitude(model, a) : a.value;
  std::vector<Parameter> list{
      {name, value / reading, unit_of(t.kind, turning), a.known ? 0 : a.std / reading, !a.known}};
  const std::string place = name.substr(name.find('['));
  if (!shape_name(t.kind).empty() && t.shape > 0)
    list.push_back({shape_name(t.kind) + place, t.shape, shape_unit(t.kind, turning), a.shape_std, true});
  if (t.kind == Kind::kPresliding && t.shape2 > 0)
    list.push_back({"bristle_time" + place, t.shape2, "s", a.shape2_std, true});
  if (t.kind == Kind::kCogging) list.push_back({"cogging_phase" + place, t.shape2, "rad", a.shape2_std, true});
  if (hum) list.push_back({"mains_frequency" + place, t.kind == Kind::kForceHumCos50 ? 50.0 : 60.0, "Hz", 0, false});
  if (t.kind == Kind::kResonance)
    list.push_back({"resonance_damping_ratio" + place, t.shape2, "1", a.shape2_std, true});
  return list;
}

std::vector<Parameter> parameters_of(const System& s, const std::vector<ActiveTerm>& model) {
  std::vector<Parameter> list;
  for (const ActiveTerm& a : model)
    if (a.companion < 0 && (a.added || !a.known))
      for (const Parameter& p : parameters_of_term(s, model, a)) list.push_back(p);
  return list;
}

void state_delays(const std::vector<Cause>& causes, rig_file::RigModel& rig) {
  for (const Cause& c : causes) {
    if (c.effect != word_of(Kind::kForceDelay) || c.parameters.empty()) continue;
    const std::string name = c.where.substr(std::string("channel ").size());
    rig_file::entry_to_write(rig, name).delay_us += 1e6 * c.parameters[0].value;
  }
}

namespace {

// What was missing, beside what the rig file states.
void correct(rig_file::Coefficient& c, double by) { c = {(c.estimate ? 0 : c.value) + by, true}; }

}  // namespace

rig_file::RigModel extended_rig(const System& s, const std::vector<ActiveTerm>& model) {
  rig_file::RigModel rig = s.rig;
  std::vector<rig_file::Link> extra(s.links.begin() + static_cast<std::ptrdiff_t>(s.known_links), s.links.end());
  for (const ActiveTerm& a : model) {
    const Term& t = a.term;
    if (!a.added) continue;
    if (t.dof >= 0) {
      rig_file::Dof& dof = rig.dofs[static_cast<size_t>(t.dof)];
      if (t.kind == Kind::kMassError) dof.mass_kg.value += a.value;
      if (t.kind == Kind::kResonance || t.kind == Kind::kDeadBand)
        dof.effects.push_back(as_effect(t, a.value, dof.rotating));
      continue;
    }
    const size_t l = static_cast<size_t>(t.link);
    rig_file::Link& link = l < s.known_links ? rig.links[l] : extra[l - s.known_links];
    if (t.kind == Kind::kMissingViscous)
      correct(link.viscous_N_s_m, a.value);
    else if (t.kind == Kind::kMissingCoulomb)
      correct(link.coulomb_N, a.value);
    else if (t.kind == Kind::kStiffnessError)
      link.stiffness_N_m.value += a.value;
    else
      link.effects.push_back(as_effect(t, a.value, rotates(s, t)));
    if (t.kind == Kind::kPresliding) link.coulomb_N = {};  // acts in its place
  }
  for (const rig_file::Link& link : extra)
    if (link.viscous_N_s_m.estimate || link.coulomb_N.estimate || link.stiffness_N_m.value != 0)
      rig.links.push_back(link);
  return rig;
}

}  // namespace diagnosis
