// Shape and strength of a hidden effect.
#include <algorithm>
#include <cmath>

#include "draw_rig.hpp"

namespace hidden_rig {
namespace {

constexpr double kTwoPi = 6.283185307179586;

bool among(const std::string& kind, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(), [&](const char* word) { return kind == word; });
}

Values elongation(const TrueLink& l, const Motion& m) {
  Values u = m.x[static_cast<size_t>(l.a)];
  if (l.b >= 0)
    for (size_t i = 0; i < u.size(); ++i) u[i] -= m.x[static_cast<size_t>(l.b)][i];
  return u;
}

double mean_power(const Values& v, double power) {
  double sum = 0;
  for (double x : v) sum += std::pow(std::abs(x), power);
  return std::pow(sum / static_cast<double>(v.size()), 1 / power);
}

// rms of the friction deficit of a Dahl element on this rate, per newton
double dahl_deficit(const Values& w, double period_s, double length) {
  double z = 0, sum = 0;
  for (double rate : w) {
    const double towards = rate > 0 ? 1 : -1;
    z = towards + (z - towards) * std::exp(-std::abs(rate) * period_s / length);
    sum += (z - towards) * (z - towards);
  }
  return std::sqrt(sum / static_cast<double>(w.size()));
}

size_t reference_link(const TrueRig& rig, const TrueEffect& e) {
  if (e.link >= 0 && !rig.links[static_cast<size_t>(e.link)].absent) return static_cast<size_t>(e.link);
  const int dof = e.link >= 0 ? rig.links[static_cast<size_t>(e.link)].a : e.dof;
  for (size_t l = 0; l < rig.links.size(); ++l)
    if (!rig.links[l].absent && (rig.links[l].a == dof || rig.links[l].b == dof)) return l;
  return 0;
}

// A DOF without a link to the ground, or -1.
int floating_dof(Dice& dice, const TrueRig& rig) {
  const int n = static_cast<int>(rig.mass_kg.size()), start = dice.below(n);
  for (int i = 0; i < n; ++i) {
    const int dof = (start + i) % n;
    if (std::none_of(rig.links.begin(), rig.links.end(), [&](const TrueLink& l) { return l.a == dof && l.b < 0; }))
      return dof;
  }
  return -1;
}

// Both act on one link's dry friction: the second would not act, or would not be missing.
bool one_friction(const std::string& a, const std::string& b) {
  const auto shapes = [](const std::string& k) { return k == "stribeck" || k == "presliding_hysteresis"; };
  return (shapes(a) || a == "missing_coulomb") && (shapes(b) || b == "missing_coulomb");
}

template <typename Level>
bool bisect_shape(TrueEffect& e, double low, double high, double target, Level level) {
  for (int i = 0; i < 50; ++i) {
    const double middle = std::sqrt(low * high);
    (level(middle) < target ? low : high) = middle;
  }
  e.shape = low;
  return level(low) > 0.8 * target && level(low) < 1.25 * target;
}

// rms force of a unit coefficient on the motion without the effect.
double unit_force(const TrueEffect& e, const Values& u, const Values& w, const Motion& m) {
  const std::string& k = e.kind;
  if (k == "cubic_stiffness") return std::pow(mean_power(u, 6), 3);
  if (k == "quadratic_stiffness") return std::pow(mean_power(u, 4), 2);
  if (among(k, {"stiffness_error", "end_stop"})) return rms(u);
  if (k == "quadratic_damping") return std::pow(mean_power(w, 4), 2);
  if (k == "cubic_damping") return std::pow(mean_power(w, 6), 3);
  if (k == "displacement_dependent_damping") return 3.9 * rms(u) * rms(u) * rms(w);
  if (among(k, {"asymmetric_viscous", "missing_viscous"})) return rms(w);
  if (k == "drifting_viscous") return 0.3 * rms(w);
  if (k == "missing_gravity_torque") {
    double sum = 0;
    for (double x : u) sum += std::sin(x) * std::sin(x);
    return std::sqrt(sum / static_cast<double>(u.size()));
  }
  if (among(k, {"mass_error", "unmodelled_resonance"})) return rms(m.a[static_cast<size_t>(e.dof)]);
  return 1.0;
}

void draw_shape(Dice& dice, TrueEffect& e, const Condition& c, const Values& u, const Values& w) {
  double peak = 0;
  for (double value : u) peak = std::max(peak, std::abs(value));
  if (e.kind == "end_stop") e.shape = dice.between(0.35, 0.75) * peak;
  if (e.kind == "stribeck") e.shape = dice.between(0.1, 0.6) * rms(w);
  if (e.kind == "cogging") e.shape = dice.between(0.15, 0.5) * peak, e.phase = dice.between(0, kTwoPi);
  if (e.kind == "drifting_viscous" && dice.chance(0.5)) e.shape = dice.log_between(0.1, 0.6);  // levels off
  if (e.kind == "unmodelled_resonance") e.shape = dice.between(8, 45) * c.pace, e.shape2 = dice.between(0.01, 0.04);
}

bool choose_place(Dice& dice, TrueEffect& e, const TrueRig& rig, const Drive& drive) {
  const int n = static_cast<int>(rig.mass_kg.size());
  if (e.kind == "drive_dead_band") {
    for (int i = 0; i < n; ++i)
      if (!drive.force_N[static_cast<size_t>(i)].empty()) e.dof = i;
    return e.dof >= 0;
  }
  if (among(e.kind, {"mass_error", "unmodelled_resonance"})) {
    e.dof = dice.below(n);
    return true;
  }
  e.link = dice.below(static_cast<int>(rig.links.size()));
  if (e.kind != "missing_gravity_torque") return true;
  return rig.rotating && rig.links[static_cast<size_t>(e.link)].b == kToGround;
}

}  // namespace

bool is_measurement_fault(const std::string& kind) {
  return among(kind, {"sensor_delay", "sensor_gain", "mains_hum", "force_delay", "force_hold", "dead", "clipped",
                      "spikes", "polarity", "unit", "drift"});
}

bool linear_in_strength(const std::string& kind) {
  return !among(kind, {"backlash", "presliding_hysteresis", "drive_dead_band"}) && !is_measurement_fault(kind);
}

double rho_of(const TrueRig& rig, const Motion& motion, size_t effect) {
  return rms(motion.hidden_force[effect]) / rms(motion.damping_force[reference_link(rig, rig.effects[effect])]);
}

const std::vector<std::string>& effects() {
  static const std::vector<std::string> words = {"cubic_stiffness",
                                                 "quadratic_stiffness",
                                                 "stiffness_error",
                                                 "backlash",
                                                 "end_stop",
                                                 "quadratic_damping",
                                                 "cubic_damping",
                                                 "stribeck",
                                                 "presliding_hysteresis",
                                                 "force_offset",
                                                 "asymmetric_viscous",
                                                 "displacement_dependent_damping",
                                                 "missing_viscous",
                                                 "missing_coulomb",
                                                 "drifting_viscous",
                                                 "mass_error",
                                                 "unmodelled_resonance",
                                                 "cogging",
                                                 "missing_gravity_torque",
                                                 "drive_dead_band",
                                                 "sensor_delay",
                                                 "sensor_gain",
                                                 "mains_hum",
                                                 "force_delay",
                                                 "force_hold",
                                                 "dead",
                                                 "clipped",
                                                 "spikes",
                                                 "polarity",
                                                 "unit",
                                                 "drift"};
  return words;
}

std::string hide(Dice& dice, const std::string& kind, const Settings& settings, const Condition& c, TrueRig& rig,
                 const Motion& motion, const Drive& drive) {
  TrueEffect e;
  e.kind = kind;
  const double rho = dice.between(settings.rho_low, settings.rho_high);
  if (!choose_place(dice, e, rig, drive)) return kind + " has no place in this rig";
  for (const TrueEffect& other : rig.effects)
    if (other.link == e.link && other.dof == e.dof && (other.kind == kind || one_friction(other.kind, kind)))
      return "two effects of one kind in one place";
  const size_t l = reference_link(rig, e);
  TrueLink& link = rig.links[l];
  if (kind == "missing_viscous" || (kind == "missing_coulomb" && (link.F > 0 || dice.chance(0.5)))) {
    TrueLink extra;
    extra.a = floating_dof(dice, rig);
    extra.absent = true;
    if (extra.a < 0) return "no DOF without a link to the ground for " + kind;
    e.link = static_cast<int>(rig.links.size());
    rig.links.push_back(extra);
  }
  const TrueLink& place = rig.links[e.link >= 0 ? static_cast<size_t>(e.link) : l];
  if (place.a < 0) return "no DOF at the link";
  const Values u = elongation(place, motion);
  const Values w = place.absent ? motion.v[static_cast<size_t>(place.a)] : motion.rate[reference_link(rig, e)];
  const double damping = rms(motion.damping_force[reference_link(rig, e)]), target = rho * damping;
  e.strength = 1;
  const double period_s = drive.sample_period_s;
  if (kind == "backlash") {
    if (!bisect_shape(e, 1e-6 * rms(u), 3 * rms(u), target, [&](double gap) {
          double sum = 0;
          for (double value : u) sum += std::pow(std::clamp(value, -gap, gap), 2);
          return place.k * std::sqrt(sum / static_cast<double>(u.size()));
        }))
      return "backlash cannot be that strong";
  } else if (kind == "drive_dead_band") {
    e.shape = target;
  } else if (kind == "presliding_hysteresis") {
    if (link.F == 0) link.F = dice.between(0.2, 0.45) * damping;
    const double slides = dice.chance(0.5) ? dice.log_between(0.3, 5) : 0;
    if (!bisect_shape(e, 1e-3 * rms(u), 0.5 * rms(u), target,
                      [&](double length) { return link.F * dahl_deficit(w, period_s, length); }))
      return "presliding_hysteresis cannot be that strong";
    e.shape2 = slides * e.shape / rms(w);
  } else {
    if (kind == "stribeck" && link.F == 0) link.F = dice.between(0.2, 0.45) * damping;
    draw_shape(dice, e, c, u, w);
    const double unit = unit_force(e, u, w, motion);
    if (!(unit > 0)) return "the place of " + kind + " does not move";
    const bool positive = among(kind, {"end_stop", "stribeck", "missing_viscous", "missing_coulomb",
                                       "unmodelled_resonance", "missing_gravity_torque"});
    e.strength = (positive ? 1.0 : dice.sign()) * target / unit;
  }
  rig.effects.push_back(e);
  return "";
}

}  // namespace hidden_rig
