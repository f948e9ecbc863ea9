// Draws rigs, effects and sensors from a seed.
#include "draw.hpp"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "sensors.hpp"
#include "tests/hidden_rig/dice.hpp"

namespace hidden {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr size_t kSkip = 1000;

// Gaussian force with a flat band of 5 to 50 Hz, at `step` seconds.
Values band_force(Dice& dice, size_t count, double step, double level) {
  std::vector<std::complex<double>> spectrum(count / 2 + 1);
  const double bin = 1 / (static_cast<double>(count) * step);
  for (size_t i = 0; i < spectrum.size(); ++i) {
    const double f = static_cast<double>(i) * bin;
    if (f >= 5 && f <= 50) spectrum[i] = {dice.gauss(), dice.gauss()};
    if (f > 50) break;
  }
  Values force(count);
  fftw_plan plan = fftw_plan_dft_c2r_1d(static_cast<int>(count), reinterpret_cast<fftw_complex*>(spectrum.data()),
                                        force.data(), FFTW_ESTIMATE);
  fftw_execute(plan);
  fftw_destroy_plan(plan);
  const double scale = level / rms(force);
  for (double& f : force) f *= scale;
  return force;
}

TrueRig draw_rig(Dice& dice, int dofs) {
  TrueRig rig;
  const int n = dofs > 0 ? dofs : 1 + dice.below(4);
  for (int i = 0; i < n; ++i) rig.mass_kg.push_back(dice.between(0.6, 2.5));
  const bool far_end = n > 1 && dice.chance(0.6);
  for (int i = 0; i <= n; ++i) {
    TrueLink link;
    link.a = i == 0 ? 0 : i - 1;
    link.b = i == 0 ? -1 : i;
    if (i == n) {
      if (!far_end) break;
      link.a = n - 1, link.b = -1;
    }
    link.k = dice.log_between(4e3, 3e4);
    link.c = dice.log_between(8, 40);
    rig.links.push_back(link);
  }
  return rig;
}

struct Kind {
  const char* word;
  bool on_dof;
};
const Kind kVocabulary[] = {{"cubic_stiffness", false},
                            {"quadratic_stiffness", false},
                            {"stiffness_error", false},
                            {"backlash", false},
                            {"end_stop", false},
                            {"quadratic_damping", false},
                            {"cubic_damping", false},
                            {"stribeck", false},
                            {"presliding_hysteresis", false},
                            {"force_offset", false},
                            {"asymmetric_viscous", false},
                            {"displacement_dependent_damping", false},
                            {"missing_viscous", false},
                            {"missing_coulomb", false},
                            {"drifting_viscous", false},
                            {"mass_error", true},
                            {"unmodelled_resonance", true}};
const Kind kOutside[] = {{"switched_damper", false}, {"pulsating_stiffness", false}, {"foreign_tone", true}};

std::string place(const TrueRig& rig, const TrueEffect& e) {
  if (e.dof >= 0) return "dof " + std::to_string(e.dof + 1);
  const TrueLink& l = rig.links[static_cast<size_t>(e.link)];
  return "link " + std::to_string(l.a + 1) + "-" + std::to_string(l.b + 1);
}

// rms of the friction deficit of a Dahl element on this rate, per newton
double dahl_deficit(const Values& w, double length) {
  double z = 0, sum = 0;
  for (double rate : w) {
    for (int i = 0; i < 4; ++i) z += kPeriod / 4 * (rate - std::abs(rate) * z) / length, z = std::clamp(z, -1.0, 1.0);
    sum += std::pow(z - (rate > 0 ? 1 : -1), 2);
  }
  return std::sqrt(sum / static_cast<double>(w.size()));
}

struct Scene {
  TrueRig rig;
  Values force;  // at half substeps of 4 substeps a sample
  size_t samples;
  Drive drive;
  Motion run() const { return integrate(rig, force, 4, samples, kSkip, kPeriod, drive); }
};

Values difference(const std::vector<Values>& rows, const TrueLink& l) {
  Values out = rows[static_cast<size_t>(l.a)];
  if (l.b >= 0)
    for (size_t i = 0; i < out.size(); ++i) out[i] -= rows[static_cast<size_t>(l.b)][i];
  return out;
}

// the link whose damping force an effect is compared with
size_t reference_link(const TrueRig& rig, const TrueEffect& e) {
  if (e.link < 0) return static_cast<size_t>(e.dof);
  const TrueLink& link = rig.links[static_cast<size_t>(e.link)];
  return static_cast<size_t>(link.absent ? link.a : e.link);
}

// Gives an effect the shape and the coefficient that bring its force to rho times the damping force of its link.
// `motion` is that of the rig without it. Returns false where the rig cannot carry the effect that strongly.
bool shape_effect(Dice& dice, TrueEffect& e, const TrueRig& rig, const Motion& motion, double rho) {
  const size_t l = reference_link(rig, e);
  const TrueLink& link = rig.links[e.link >= 0 ? static_cast<size_t>(e.link) : l];
  const Values u = difference(motion.x, link), w = difference(motion.v, link);
  const double damping = rms(motion.damping_force[l]), ru = rms(u), rw = rms(w), target = rho * damping;
  double peak = 0;
  for (double value : u) peak = std::max(peak, std::abs(value));
  e.strength = 1;
  const auto bisect = [&](double low, double high, auto level) {
    for (int i = 0; i < 50; ++i) {
      const double mid = std::sqrt(low * high);
      (level(mid) < target ? low : high) = mid;
    }
    e.shape = low;
    return level(low) > 0.8 * target && level(low) < 1.25 * target;
  };
  if (e.kind == "backlash")
    return bisect(1e-6 * peak, peak, [&](double gap) {
      double sum = 0;
      for (double value : u) sum += std::pow(std::clamp(value, -gap, gap), 2);
      return link.k * std::sqrt(sum / static_cast<double>(u.size()));
    });
  if (e.kind == "drifting_viscous" && dice.chance(0.5))  // levels off, as heating does
    e.shape = dice.log_between(0.1, 0.6) * static_cast<double>(motion.x[0].size()) * kPeriod;
  if (e.kind == "presliding_hysteresis") {
    const double slides =
        dice.chance(0.5) ? dice.log_between(0.3, 5) : 0;  // LuGre's bristles are damped, Dahl's are not
    const bool shaped = bisect(1e-3 * ru, 0.5 * ru, [&](double length) { return link.F * dahl_deficit(w, length); });
    e.shape2 = slides * e.shape / rw;
    return shaped;
  }
  const double sign = dice.sign();
  if (e.kind == "end_stop") e.shape = dice.between(0.35, 0.75) * peak;
  if (e.kind == "stribeck") e.shape = dice.between(0.1, 0.6) * rw;
  if (e.kind == "switched_damper") e.shape = dice.between(0.5, 4);
  if (e.kind == "pulsating_stiffness") e.shape = dice.between(0.3, 2);
  if (e.kind == "foreign_tone") e.shape = dice.between(7, 45);
  if (e.kind == "unmodelled_resonance") e.shape = dice.between(8, 45), e.shape2 = dice.between(0.01, 0.04);
  const bool positive = e.kind == "end_stop" || e.kind == "stribeck" || e.kind == "missing_viscous" ||
                        e.kind == "missing_coulomb" || e.kind == "unmodelled_resonance";
  if (!positive) e.strength = sign;
  // a first coefficient from the undisturbed motion, by the same formula on one tiny run's scale
  const double guess = target / std::max(1e-300, [&] {
                         const std::string& k = e.kind;
                         if (k == "cubic_stiffness") return 3.9 * ru * ru * ru;
                         if (k == "quadratic_stiffness") return 1.7 * ru * ru;
                         if (k == "stiffness_error" || k == "pulsating_stiffness" || k == "end_stop") return ru;
                         if (k == "quadratic_damping") return 1.7 * rw * rw;
                         if (k == "cubic_damping") return 3.9 * rw * rw * rw;
                         if (k == "displacement_dependent_damping") return 3.9 * ru * ru * rw;
                         if (k == "asymmetric_viscous" || k == "missing_viscous" || k == "switched_damper") return rw;
                         if (k == "drifting_viscous") return 0.3 * rw;
                         if (k == "mass_error" || k == "unmodelled_resonance")
                           return rms(motion.a[static_cast<size_t>(e.dof)]);
                         return 1.0;
                       }());
  e.strength *= guess;
  return true;
}

bool linear_strength(const std::string& kind) { return kind != "backlash" && kind != "presliding_hysteresis"; }

double rho_of(const Scene& scene, const Motion& motion, size_t effect) {
  const TrueEffect& e = scene.rig.effects[effect];
  return rms(motion.hidden_force[effect]) / rms(motion.damping_force[reference_link(scene.rig, e)]);
}

// A DOF (from 0) without a link to the ground, or -1.
int floating_dof(Dice& dice, const TrueRig& rig) {
  const int n = static_cast<int>(rig.mass_kg.size()), start = dice.below(n);
  for (int i = 0; i < n; ++i) {
    const int dof = (start + i) % n;
    bool grounded = false;
    for (const TrueLink& l : rig.links) grounded = grounded || (l.a == dof && l.b < 0);
    if (!grounded) return dof;
  }
  return -1;
}

// Two effects of one link's friction of which the second would not act (a Dahl element stands in for all dry friction) or
// would not be missing (what bends Coulomb friction is drawn on a link whose friction the rig file knows).
bool one_friction(const std::string& a, const std::string& b) {
  const auto bends = [](const std::string& kind) { return kind == "stribeck" || kind == "presliding_hysteresis"; };
  return (bends(a) || a == "missing_coulomb") && (bends(b) || b == "missing_coulomb");
}

bool hide_effect(Dice& dice, Scene& scene, Motion& plain, const Settings& s, bool outside) {
  const size_t count = outside ? std::size(kOutside) : std::size(kVocabulary);
  const size_t pick = static_cast<size_t>(dice.below(static_cast<int>(count)));
  TrueEffect e;
  e.kind = outside ? kOutside[pick].word : kVocabulary[pick].word;
  bool on_dof = outside ? kOutside[pick].on_dof : kVocabulary[pick].on_dof;
  if (!s.kind.empty()) {
    e.kind = s.kind;
    on_dof = s.kind == "mass_error" || s.kind == "unmodelled_resonance" || s.kind == "foreign_tone";
  }
  if (on_dof)
    e.dof = dice.below(static_cast<int>(scene.rig.mass_kg.size()));
  else
    e.link = dice.below(static_cast<int>(scene.rig.links.size()));
  for (const TrueEffect& other : scene.rig.effects)
    if (other.link == e.link && other.dof == e.dof && (other.kind == e.kind || one_friction(other.kind, e.kind)))
      return false;
  const double rho = dice.between(s.rho_low, s.rho_high);
  if (e.kind == "missing_viscous" || (e.kind == "missing_coulomb" && dice.chance(0.5))) {
    TrueLink link;
    link.a = floating_dof(dice, scene.rig), link.absent = true;
    if (link.a < 0) return false;
    e.link = static_cast<int>(scene.rig.links.size());
    scene.rig.links.push_back(link);
    plain = scene.run();
  }
  TrueLink* link = on_dof ? nullptr : &scene.rig.links[static_cast<size_t>(e.link)];
  if (e.kind == "missing_coulomb" && link->F > 0) return false;
  if ((e.kind == "presliding_hysteresis" || e.kind == "stribeck") && link->F == 0) {
    link->F = dice.between(0.2, 0.45) * rms(plain.damping_force[static_cast<size_t>(e.link)]);
    plain = scene.run();
  }
  if (!shape_effect(dice, e, scene.rig, plain, rho)) return false;
  scene.rig.effects.push_back(e);
  return true;
}

void tune_strengths(Scene& scene, const std::vector<double>& rho) {
  for (int pass = 0; pass < 3; ++pass) {
    const Motion motion = scene.run();
    for (size_t i = 0; i < scene.rig.effects.size(); ++i)
      if (linear_strength(scene.rig.effects[i].kind))
        scene.rig.effects[i].strength *= std::clamp(rho[i] / rho_of(scene, motion, i), 0.2, 5.0);
  }
}

void believe(Draw& draw, const TrueRig& rig) {
  draw.rig.name = "blind draw";
  for (double m : rig.mass_kg) {
    rig_file::Dof dof;
    dof.mass_kg.value = m;
    draw.rig.dofs.push_back(dof);
  }
  for (size_t l = 0; l < rig.links.size(); ++l) {
    if (rig.links[l].absent) continue;
    rig_file::Link link;
    link.a = rig.links[l].a + 1, link.b = rig.links[l].b + 1;
    link.stiffness_N_m.value = rig.links[l].k;
    link.viscous_N_s_m.estimate = true;
    link.coulomb_N.estimate = rig.links[l].F > 0;
    draw.rig.links.push_back(link);
  }
}

Values force_of(const Scene& scene) {
  Values force(scene.samples);
  for (size_t i = 0; i < scene.samples; ++i) force[i] = scene.force[(i + kSkip) * 8];
  return force;
}

}  // namespace

Draw make_draw(uint64_t seed, const Settings& s) {
  Dice dice(seed);
  for (;;) {
    Scene scene;
    scene.drive = s.drive;
    scene.samples = static_cast<size_t>(s.seconds / kPeriod + 0.5);
    scene.rig = draw_rig(dice, s.dofs);
    scene.force = band_force(dice, (scene.samples + kSkip + 2) * 8, kPeriod / 8, dice.log_between(10, 40));
    Motion motion = scene.run();
    for (size_t l = 0; l < scene.rig.links.size(); ++l)  // Coulomb friction on a third of the links
      if (dice.chance(0.35) || (l == 0 && (s.kind == "stribeck" || s.kind == "presliding_hysteresis")))
        scene.rig.links[l].F = dice.between(0.1, 0.45) * rms(motion.damping_force[l]);
    motion = scene.run();
    const int wanted = s.hide == Hide::kOne || s.hide == Hide::kOutside ? 1 : s.hide == Hide::kTwo ? 2 : 0;
    std::vector<double> rho;
    bool drawn = true;
    for (int i = 0; i < wanted && drawn; ++i) {
      drawn = hide_effect(dice, scene, motion, s, s.hide == Hide::kOutside);
      rho.push_back(dice.between(s.rho_low, s.rho_high));
    }
    if (!drawn) continue;
    tune_strengths(scene, rho);
    motion = scene.run();
    Draw draw;
    draw.true_rig = scene.rig;
    believe(draw, scene.rig);
    bool ok = true;
    for (size_t i = 0; i < scene.rig.effects.size(); ++i) {
      const double level = rho_of(scene, motion, i);
      const bool within = level > 0.9 * s.rho_low && level < 1.1 * s.rho_high;
      ok = ok && std::isfinite(level) && within;
      draw.truth.push_back({s.hide == Hide::kOutside ? "outside" : scene.rig.effects[i].kind,
                            place(scene.rig, scene.rig.effects[i]), level, scene.rig.effects[i].strength});
    }
    if (!ok) continue;
    measure(dice, draw, motion, force_of(scene), s);
    return draw;
  }
}

}  // namespace hidden
