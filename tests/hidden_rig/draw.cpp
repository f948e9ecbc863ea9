#include "draw.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "draw_rig.hpp"
#include "effect_force.hpp"
#include "excitation.hpp"
#include "sensors.hpp"

namespace hidden_rig {
namespace {

constexpr int kMostAttempts = 200;
constexpr double kLeastMotion = 0.03;  // free decays are cut where the motion falls below this share of its start

struct Lengths {
  size_t samples, skip, lead_in;
  size_t all() const { return samples + skip; }
};

bool decays(const Condition& c) {
  return c.excitation == Excitation::kFreeDecay || c.excitation == Excitation::kFreeDecayToRest;
}

Lengths lengths_of(const Condition& c) {
  Lengths l;
  l.samples = static_cast<size_t>(c.seconds * c.rate_Hz + 0.5);
  double settle_s = 1 / c.pace;
  if (c.excitation == Excitation::kSteppedSine || c.excitation == Excitation::kSineRecords) settle_s = 4 / c.pace;
  if (c.excitation == Excitation::kHammer) settle_s = 0;
  l.lead_in = c.filter == AntiAlias::kNone || decays(c) ? 0 : kLeadIn;
  l.skip = decays(c) ? 0 : std::max(static_cast<size_t>(settle_s * c.rate_Hz), l.lead_in);
  return l;
}

class Attempt {
 public:
  Attempt(Dice& dice, const Settings& settings)
      : dice_(dice), s_(settings), c_(condition(settings.condition)), length_(lengths_of(c_)) {}

  // Empty, or why this draw is thrown away.
  std::string make(Draw& draw) {
    draw.true_rig = draw_rig(dice_, c_, s_.masses);
    TrueRig& rig = draw.true_rig;
    shakers_ = draw_shakers(dice_, c_, rig);
    pilot_ = draw_drive(dice_, c_, rig, shakers_, 0, length_.all());
    draw_friction(dice_, c_, rig, run(rig));
    if (const std::string problem = hide_effects(rig); !problem.empty()) return problem;
    if (const std::string problem = tune(rig); !problem.empty()) return problem;
    believe(draw);
    simulate(draw);
    for (const Motion& m : draw.motion)
      for (const Values& x : m.x)
        if (x.empty() || !std::isfinite(rms(x))) return "the motion is not finite";
    tell_truth(draw);
    for (size_t r = 0; r < draw.motion.size(); ++r)
      draw.records.push_back(measure(dice_, c_, sensors_, rig, draw.motion[r], draw.drive[r],
                                     length_.skip - length_.lead_in, length_.lead_in));
    for (size_t r = 0; r < draw.records.size(); ++r) draw.records[r].file = "record_" + std::to_string(r + 1) + ".csv";
    return "";
  }

 private:
  Motion run(const TrueRig& rig) const { return integrate(rig, pilot_, length_.samples, length_.skip); }

  std::string hide_effects(TrueRig& rig) {
    choose_sensors(rig.mass_kg.size());
    std::vector<std::string> kinds;
    if (s_.hidden == "any" || s_.hidden == "two") {
      const std::vector<std::string>& all = effects();
      for (int i = 0; i < (s_.hidden == "two" ? 2 : 1); ++i)
        kinds.push_back(all[static_cast<size_t>(dice_.below(static_cast<int>(all.size())))]);
    } else if (s_.hidden != "none") {
      kinds.push_back(s_.hidden);
    }
    for (const std::string& kind : kinds) {
      if (!is_measurement_fault(kind)) {
        const std::string problem = hide(dice_, kind, s_, c_, rig, run(rig), pilot_);
        if (!problem.empty()) return problem;
        continue;
      }
      TrueEffect fault = draw_fault(dice_, kind, channel_names(rig), 1 / c_.rate_Hz);
      if (fault.channel.empty()) return "no channel for " + kind;
      if (s_.fault != 0) fault.strength = s_.fault;
      rig.effects.push_back(fault);
      held_ = held_ || kind == "force_hold";
    }
    pilot_.held = held_;
    return "";
  }

  void choose_sensors(size_t masses) {
    static const char* const kSets[] = {"xva", "xa", "va", "xv", "x", "v", "a"};
    for (size_t i = 0; i < masses; ++i) sensors_.push_back(s_.sensors == "mixed" ? kSets[dice_.below(7)] : s_.sensors);
    sensors_.push_back(s_.sensors == "mixed" ? "xva" : s_.sensors);  // of the base
  }
  std::vector<std::string> channel_names(const TrueRig& rig) {
    Dice none(0);
    Motion still;
    still.x = still.v = still.a = std::vector<Values>(rig.mass_kg.size(), Values(length_.lead_in + 32, 0.0));
    Condition quiet = c_;
    quiet.noise = quiet.drift = quiet.hum_Hz = 0;
    const host_sim::Record record =
        measure(none, quiet, sensors_, rig, still, pilot_, length_.skip - length_.lead_in, length_.lead_in);
    std::vector<std::string> names;
    for (const host_sim::Channel& channel : record.channels) names.push_back(channel.name);
    return names;
  }

  // Brings the strengths to what they were asked to be on the motion that they change.
  std::string tune(TrueRig& rig) {
    std::vector<double> wanted;
    for (size_t e = 0; e < rig.effects.size(); ++e) wanted.push_back(dice_.between(s_.rho_low, s_.rho_high));
    for (int pass = 0; pass < 5; ++pass) {
      const Motion motion = run(rig);
      for (size_t e = 0; e < rig.effects.size(); ++e) {
        if (is_measurement_fault(rig.effects[e].kind)) continue;
        const double level = rho_of(rig, motion, e);
        if (pass == 4 && !(level > 0.9 * s_.rho_low && level < 1.1 * s_.rho_high))
          return rig.effects[e].kind + " does not reach its strength";
        if (linear_in_strength(rig.effects[e].kind)) rig.effects[e].strength *= std::clamp(wanted[e] / level, 0.2, 5.0);
      }
      if (rig.effects.empty()) break;
    }
    return "";
  }

  void believe(Draw& draw) {
    const TrueRig& rig = draw.true_rig;
    draw.rig.name = "drawn rig, " + c_.name;
    const bool all = c_.masses_and_springs_unknown;
    for (double m : rig.mass_kg) {
      rig_file::Dof dof;
      dof.rotating = rig.rotating;
      dof.mass_kg = {all ? 0.0 : m, all};
      draw.rig.dofs.push_back(dof);
    }
    const auto number = [](int node) { return node >= 0 ? node + 1 : (node == kToBase ? rig_file::kBase : 0); };
    for (const TrueLink& true_link : rig.links) {
      if (true_link.absent) continue;
      rig_file::Link link;
      link.a = number(true_link.a);
      link.b = number(true_link.b);
      link.stiffness_N_m = {all ? 0.0 : true_link.k, all};
      link.viscous_N_s_m.estimate = true;
      link.coulomb_N.estimate = true_link.F > 0;
      draw.rig.links.push_back(link);
    }
  }

  void simulate(Draw& draw) {
    const TrueRig& rig = draw.true_rig;
    for (int r = 0; r < c_.records; ++r) {
      Drive drive = r == 0 ? pilot_ : draw_drive(dice_, c_, rig, shakers_, r, length_.all());
      drive.held = held_;
      const double place = c_.records > 1 ? static_cast<double>(r) / (c_.records - 1) - 0.5 : 0.0;
      const std::vector<double> viscous(rig.links.size(), 1 + c_.warming * place);
      Motion motion = integrate(rig, drive, length_.samples + length_.lead_in, length_.skip - length_.lead_in, viscous);
      if (c_.excitation == Excitation::kFreeDecay) cut(motion);
      draw.drive.push_back(drive);
      draw.motion.push_back(motion);
      viscous_scale_.push_back(viscous[0]);
    }
  }
  // Ends the record where the motion of the last tenth of a second falls below kLeastMotion of the first's.
  void cut(Motion& m) const {
    const size_t window = static_cast<size_t>(0.1 / c_.pace * c_.rate_Hz), count = m.x[0].size();
    const auto energy = [&](size_t from) {
      double sum = 0;
      for (const Values& v : m.v)
        for (size_t i = from; i < from + window; ++i) sum += v[i] * v[i];
      return sum;
    };
    size_t end = 3 * window;
    while (end + window <= count && energy(end - window) > kLeastMotion * kLeastMotion * energy(0)) end += window / 4;
    for (auto* rows : {&m.x, &m.v, &m.a, &m.damping_force, &m.rate, &m.hidden_force})
      for (Values& row : *rows)
        if (!row.empty()) row.resize(std::min(end, count));
  }

  // A rig file's drift counts from the start of the record, the drawn one from the mean over it.
  static double drift_at_start(const TrueRig& rig, size_t link) {
    double sum = 0;
    for (const TrueEffect& e : rig.effects)
      if (e.kind == "drifting_viscous" && e.link == static_cast<int>(link))
        sum += law_force(Law::kDriftingViscous, e, 0, 0, 1, 0);
    return sum;
  }

  // What the rig file leaves to be estimated it is not wrong about: the hidden mass or stiffness is part of what is found.
  static double hidden_part(const TrueRig& rig, const char* kind, size_t dof_or_link) {
    double sum = 0;
    for (const TrueEffect& e : rig.effects)
      if (e.kind == kind && static_cast<size_t>(e.kind == "mass_error" ? e.dof : e.link) == dof_or_link)
        sum += e.strength;
    return sum;
  }

  void tell_truth(Draw& draw) const {
    const TrueRig& rig = draw.true_rig;
    const auto add = [&](const std::string& name, double value, bool viscous) {
      TrueCoefficient t{name, 0, {}};
      for (double scale : viscous_scale_) t.of_record.push_back(value * (viscous ? scale : 1.0));
      for (double v : t.of_record) t.value += v / static_cast<double>(t.of_record.size());
      draw.coefficients.push_back(t);
    };
    for (size_t i = 0; i < rig.mass_kg.size(); ++i)
      if (draw.rig.dofs[i].mass_kg.estimate)
        add("mass[" + std::to_string(i + 1) + "]", rig.mass_kg[i] + hidden_part(rig, "mass_error", i), false);
    size_t believed = 0;
    for (size_t l = 0; l < rig.links.size(); ++l) {
      const TrueLink& link = rig.links[l];
      if (link.absent) continue;
      const rig_file::Link& told = draw.rig.links[believed++];
      const std::string label = "[" + rig_file::link_label(told) + "]";
      if (told.stiffness_N_m.estimate) add("stiffness" + label, link.k + hidden_part(rig, "stiffness_error", l), false);
      add("viscous" + label, link.c + drift_at_start(rig, l), true);
      if (told.coulomb_N.estimate) add("coulomb" + label, link.F, false);
    }
    for (size_t e = 0; e < rig.effects.size(); ++e) {
      const TrueEffect& effect = rig.effects[e];
      Hidden h;
      h.effect = effect.kind == "force_delay" ? "sensor_delay" : effect.kind;
      h.where = place(rig, effect);
      h.strength = effect.strength;
      h.shape = effect.shape;
      h.rho = is_measurement_fault(effect.kind) ? std::abs(effect.strength) : rho_of(rig, draw.motion[0], e);
      draw.hidden.push_back(h);
    }
  }

  Dice& dice_;
  const Settings& s_;
  const Condition& c_;
  Lengths length_;
  Shakers shakers_;
  Drive pilot_;
  bool held_ = false;
  std::vector<std::string> sensors_;  // of every DOF, then of the base
  std::vector<double> viscous_scale_;
};

}  // namespace

std::string place(const TrueRig& rig, const TrueEffect& e) {
  if (!e.channel.empty()) return "channel " + e.channel;
  const std::string torque = "torque_" + std::to_string(e.dof + 1) + "_N_m",
                    force = "force_" + std::to_string(e.dof + 1) + "_N";
  if (e.kind == "drive_dead_band") return "channel " + (rig.rotating ? torque : force);
  if (e.dof >= 0) return "dof " + std::to_string(e.dof + 1);
  const TrueLink& l = rig.links[static_cast<size_t>(e.link)];
  return "link " + std::to_string(l.a + 1) + "-" + (l.b == kToBase ? "base" : std::to_string(l.b + 1));
}

Draw make_draw(uint64_t seed, const Settings& settings) {
  Dice dice(seed);
  std::map<std::string, int> redrawn;
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    Draw draw;
    const std::string problem = Attempt(dice, settings).make(draw);
    if (problem.empty()) {
      draw.redrawn = redrawn;
      return draw;
    }
    ++redrawn[problem];
  }
  std::string why;
  for (const auto& [reason, count] : redrawn) why += "; " + std::to_string(count) + " times: " + reason;
  throw std::runtime_error("no rig can be drawn for condition " + settings.condition + ", hidden " + settings.hidden +
                           why);
}

}  // namespace hidden_rig
