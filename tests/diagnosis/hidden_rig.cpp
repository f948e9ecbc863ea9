// Runge-Kutta of order four between friction events; each velocity reversal is located inside its substep and ends in
// sticking or in sliding the other way.
#include "hidden_rig.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace hidden {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr double kAtRest = 1e-6;  // m/s; a located reversal is a thousand times closer to rest

enum class Kind {
  kCubicStiffness,
  kQuadraticStiffness,
  kStiffnessError,
  kBacklash,
  kEndStop,
  kQuadraticDamping,
  kCubicDamping,
  kForceOffset,
  kAsymmetricViscous,
  kDisplacementDependentDamping,
  kMissingViscous,
  kDriftingViscous,
  kCogging,
  kSwitchedDamper,
  kPulsatingStiffness,
  kPreslidingHysteresis,
  kMissingCoulomb,
  kStribeck,
  kMassError,
  kForeignTone,
  kUnmodelledResonance
};
constexpr const char* kWords[] = {"cubic_stiffness",
                                  "quadratic_stiffness",
                                  "stiffness_error",
                                  "backlash",
                                  "end_stop",
                                  "quadratic_damping",
                                  "cubic_damping",
                                  "force_offset",
                                  "asymmetric_viscous",
                                  "displacement_dependent_damping",
                                  "missing_viscous",
                                  "drifting_viscous",
                                  "cogging",
                                  "switched_damper",
                                  "pulsating_stiffness",
                                  "presliding_hysteresis",
                                  "missing_coulomb",
                                  "stribeck",
                                  "mass_error",
                                  "foreign_tone",
                                  "unmodelled_resonance"};  // in the order of Kind

Kind kind_of(const std::string& word) {
  const auto found = std::find(std::begin(kWords), std::end(kWords), word);
  if (found == std::end(kWords)) throw std::invalid_argument("no hidden effect is called " + word);
  return static_cast<Kind>(found - std::begin(kWords));
}

struct Integrator {
  const TrueRig& rig;
  size_t n, links;
  std::vector<int> mode;     // per link: -1 or 1 sliding that way, 0 stuck
  std::vector<double> hold;  // friction force of a stuck link
  std::vector<Kind> kind;    // per effect
  std::vector<int> memory;   // per effect: index of its first extra state, or -1
  size_t states;
  double duration = 1;

  explicit Integrator(const TrueRig& r) : rig(r), n(r.mass_kg.size()), links(r.links.size()) {
    for (const TrueEffect& e : r.effects) kind.push_back(kind_of(e.kind));
    mode.assign(links, 1);
    for (size_t l = 0; l < links; ++l) mode[l] = friction_level(l, 0) > 0 ? 0 : 1;
    hold.assign(links, 0);
    states = 2 * n;
    for (Kind k : kind) {
      memory.push_back(-1);
      if (k == Kind::kPreslidingHysteresis) memory.back() = static_cast<int>(states), states += 1;
      if (k == Kind::kUnmodelledResonance) memory.back() = static_cast<int>(states), states += 2;
    }
  }
  double of(const std::vector<double>& s, int dof, size_t base) const {
    return dof < 0 ? 0.0 : s[base + static_cast<size_t>(dof)];
  }
  double elongation(const std::vector<double>& s, size_t l) const {
    return of(s, rig.links[l].a, 0) - of(s, rig.links[l].b, 0);
  }
  double rate(const std::vector<double>& s, size_t l) const {
    return of(s, rig.links[l].a, n) - of(s, rig.links[l].b, n);
  }
  const TrueEffect* on_link(size_t l, Kind wanted) const {
    for (size_t i = 0; i < kind.size(); ++i)
      if (rig.effects[i].link == static_cast<int>(l) && kind[i] == wanted) return &rig.effects[i];
    return nullptr;
  }
  // sliding friction level of a link at rate w
  double friction_level(size_t l, double w) const {
    if (on_link(l, Kind::kPreslidingHysteresis)) return 0;
    double level = rig.links[l].F;
    if (const TrueEffect* e = on_link(l, Kind::kMissingCoulomb)) level += e->strength;
    if (const TrueEffect* e = on_link(l, Kind::kStribeck)) level += e->strength * std::exp(-std::abs(w) / e->shape);
    return level;
  }
  // from -0.5 to 0.5 in a straight line, or levelling off; without a mean over the record
  double drift(double tau, double t) const {
    if (!(tau > 0)) return t / duration - 0.5;
    return tau / duration * (1 - std::exp(-duration / tau)) - std::exp(-t / tau);
  }
  double effect_force(size_t i, const std::vector<double>& s, double t) const {
    const TrueEffect& e = rig.effects[i];
    if (e.link < 0) return 0;
    const size_t l = static_cast<size_t>(e.link);
    const double u = elongation(s, l), w = rate(s, l), k = rig.links[l].k;
    const auto clip = [&] { return std::clamp(u, -e.shape, e.shape); };
    switch (kind[i]) {
      case Kind::kCubicStiffness:
        return e.strength * u * u * u;
      case Kind::kQuadraticStiffness:
        return e.strength * u * u;
      case Kind::kStiffnessError:
        return e.strength * u;
      case Kind::kBacklash:
        return -k * clip();
      case Kind::kEndStop:
        return e.strength * (u - clip());
      case Kind::kQuadraticDamping:
        return e.strength * w * std::abs(w);
      case Kind::kCubicDamping:
        return e.strength * w * w * w;
      case Kind::kForceOffset:
        return e.strength;
      case Kind::kAsymmetricViscous:
        return e.strength * std::abs(w);
      case Kind::kDisplacementDependentDamping:
        return e.strength * u * u * w;
      case Kind::kMissingViscous:
        return e.strength * w;
      case Kind::kDriftingViscous:
        return e.strength * w * drift(e.shape, std::max(t, 0.0));
      case Kind::kCogging:
        return e.strength * std::sin(kTwoPi * u / e.shape);
      case Kind::kSwitchedDamper:
        return std::fmod(t, e.shape) < 0.5 * e.shape ? e.strength * w : 0.0;
      case Kind::kPulsatingStiffness:
        return e.strength * u * std::sin(kTwoPi * t / e.shape);
      case Kind::kPreslidingHysteresis: {
        const double z = s[static_cast<size_t>(memory[i])];
        return rig.links[l].F * (z + e.shape2 * (w - std::abs(w) * z) / e.shape);
      }
      default:
        return 0;  // friction kinds are part of friction_level
    }
  }
  // derivative of the state; also fills hold[] for stuck links
  void slope(const std::vector<double>& s, double t, double force, std::vector<double>& d) {
    std::fill(d.begin(), d.end(), 0.0);
    for (size_t i = 0; i < n; ++i) d[i] = s[n + i];
    double* push = &d[n];
    push[0] = force;
    double inertia[8];
    for (size_t i = 0; i < n; ++i) inertia[i] = rig.mass_kg[i];
    const auto add = [&](size_t l, double f) {
      if (rig.links[l].a >= 0) push[rig.links[l].a] -= f;
      if (rig.links[l].b >= 0) push[rig.links[l].b] += f;
    };
    for (size_t l = 0; l < links; ++l) {
      const double w = rate(s, l);
      add(l, rig.links[l].k * elongation(s, l) + rig.links[l].c * w + mode[l] * friction_level(l, w));
    }
    for (size_t i = 0; i < rig.effects.size(); ++i) {
      const TrueEffect& e = rig.effects[i];
      if (e.link >= 0) add(static_cast<size_t>(e.link), effect_force(i, s, t));
      if (kind[i] == Kind::kPreslidingHysteresis) {
        const size_t z = static_cast<size_t>(memory[i]);
        const double w = rate(s, static_cast<size_t>(e.link));
        d[z] = (w - std::abs(w) * s[z]) / e.shape;
      }
      if (e.dof < 0) continue;
      const size_t j = static_cast<size_t>(e.dof);
      if (kind[i] == Kind::kMassError) inertia[j] += e.strength;
      if (kind[i] == Kind::kForeignTone) push[j] -= e.strength * std::sin(kTwoPi * e.shape * t);
      if (kind[i] == Kind::kUnmodelledResonance) {
        const size_t z = static_cast<size_t>(memory[i]);
        const double omega = kTwoPi * e.shape;
        const double f = e.strength * (omega * omega * (s[j] - s[z]) + 2 * e.shape2 * omega * (s[n + j] - s[z + 1]));
        push[j] -= f;
        d[z] = s[z + 1];
        d[z + 1] = f / e.strength;
      }
    }
    for (size_t i = 0; i < n; ++i) push[i] /= inertia[i];
    hold_stuck(push, inertia);
  }
  // friction of stuck links keeps their rates at zero (Gauss-Seidel on few unknowns)
  void hold_stuck(double* acceleration, const double* inertia) {
    for (size_t l = 0; l < links; ++l) hold[l] = 0;
    bool any = false;
    for (size_t l = 0; l < links; ++l) any = any || mode[l] == 0;
    for (int sweep = 0; any && sweep < 60; ++sweep) {
      double worst = 0;
      for (size_t l = 0; l < links; ++l) {
        if (mode[l] != 0) continue;
        const int a = rig.links[l].a, b = rig.links[l].b;
        double gap = 0, compliance = 0;
        if (a >= 0) gap += acceleration[a], compliance += 1 / inertia[a];
        if (b >= 0) gap -= acceleration[b], compliance += 1 / inertia[b];
        const double f = gap / compliance;
        hold[l] += f;
        if (a >= 0) acceleration[a] -= f / inertia[a];
        if (b >= 0) acceleration[b] += f / inertia[b];
        worst = std::max(worst, std::abs(gap));
      }
      if (worst < 1e-12) break;
    }
  }
  // Takes from stuck links the rates that locating their reversals left: of the wrong sign they would end the next slide.
  void bring_to_rest(std::vector<double>& s) const {
    for (int sweep = 0; sweep < 60; ++sweep) {
      double worst = 0;
      for (size_t l = 0; l < links; ++l) {
        if (mode[l] != 0) continue;
        const int a = rig.links[l].a, b = rig.links[l].b;
        const double w = rate(s, l), ia = a >= 0 ? 1 / rig.mass_kg[static_cast<size_t>(a)] : 0,
                     ib = b >= 0 ? 1 / rig.mass_kg[static_cast<size_t>(b)] : 0;
        if (a >= 0) s[n + static_cast<size_t>(a)] -= w * ia / (ia + ib);
        if (b >= 0) s[n + static_cast<size_t>(b)] += w * ib / (ia + ib);
        worst = std::max(worst, std::abs(w));
      }
      if (worst < 1e-18) break;
    }
  }
  std::vector<double> k1, k2, k3, k4, tmp;
  void runge_kutta(const std::vector<double>& s, double t, double h, double f0, double fm, double f1,
                   std::vector<double>& out) {
    for (auto* k : {&k1, &k2, &k3, &k4, &tmp}) k->resize(states);
    slope(s, t, f0, k1);
    for (size_t i = 0; i < states; ++i) tmp[i] = s[i] + 0.5 * h * k1[i];
    slope(tmp, t + 0.5 * h, fm, k2);
    for (size_t i = 0; i < states; ++i) tmp[i] = s[i] + 0.5 * h * k2[i];
    slope(tmp, t + 0.5 * h, fm, k3);
    for (size_t i = 0; i < states; ++i) tmp[i] = s[i] + h * k3[i];
    slope(tmp, t + h, f1, k4);
    for (size_t i = 0; i < states; ++i) out[i] = s[i] + h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  }
  // A link that has reversed, or that its friction no longer holds; -1: none.
  int event_link(const std::vector<double>& s, double t, double force) {
    bool any_stuck = false;
    for (size_t l = 0; l < links; ++l) {
      any_stuck = any_stuck || mode[l] == 0;
      if (mode[l] != 0 && mode[l] * rate(s, l) < 0 && friction_level(l, 0) > 0) return static_cast<int>(l);
    }
    if (!any_stuck) return -1;
    slope(s, t, force, tmp);
    for (size_t l = 0; l < links; ++l)
      if (mode[l] == 0 && std::abs(hold[l]) > friction_level(l, 0)) return static_cast<int>(l);
    return -1;
  }
  // one substep; f(r) is the force at the fraction r of the substep, quadratic through three points
  void substep(std::vector<double>& s, double t, double h, double f0, double fm, double f1) {
    const auto f = [&](double r) { return f0 + r * (-3 * f0 + 4 * fm - f1) + 2 * r * r * (f0 - 2 * fm + f1); };
    std::vector<double> next(states);
    double from = 0;
    for (int events = 0; events < 12 && from < 1; ++events) {
      const double rest = 1 - from;
      const auto advance = [&](double r) {
        runge_kutta(s, t + from * h, r * rest * h, f(from), f(from + 0.5 * r * rest), f(from + r * rest), next);
        return event_link(next, t + (from + r * rest) * h, f(from + r * rest));
      };
      if (advance(1) < 0 || events == 11) break;
      double low = 0, high = 1;  // fractions of the rest: no event, event
      for (int i = 0; i < 30 && high - low > 1e-7; ++i) {
        const double r = 0.5 * (low + high);
        (advance(r) < 0 ? low : high) = r;
      }
      const size_t l = static_cast<size_t>(advance(high));
      s = next;
      from += high * rest;
      if (std::abs(rate(s, l)) > kAtRest) {  // it slides the other way since before: too many events at once
        mode[l] = rate(s, l) > 0 ? 1 : -1;
        continue;
      }
      mode[l] = 0;
      bring_to_rest(s);
      slope(s, t + from * h, f(from), tmp);
      if (std::abs(hold[l]) > friction_level(l, 0)) mode[l] = hold[l] > 0 ? 1 : -1;
    }
    s = next;
  }
  double hidden_force(size_t i, const std::vector<double>& s, double t, const std::vector<double>& d) const {
    const TrueEffect& e = rig.effects[i];
    if (e.link >= 0) {
      const size_t l = static_cast<size_t>(e.link);
      const double w = rate(s, l), way = w > 0 ? 1 : -1;
      if (kind[i] == Kind::kStribeck) return mode[l] * e.strength * std::exp(-std::abs(w) / e.shape);
      if (kind[i] == Kind::kMissingCoulomb) return mode[l] * e.strength;
      if (kind[i] == Kind::kPreslidingHysteresis) return effect_force(i, s, t) - rig.links[l].F * way;
      return effect_force(i, s, t);
    }
    const size_t j = static_cast<size_t>(e.dof);
    if (kind[i] == Kind::kMassError) return e.strength * d[n + j];
    if (kind[i] == Kind::kForeignTone) return e.strength * std::sin(kTwoPi * e.shape * t);
    if (kind[i] == Kind::kUnmodelledResonance) return e.strength * d[static_cast<size_t>(memory[i]) + 1];
    return 0;
  }
};

}  // namespace

Motion integrate(const TrueRig& rig, const std::vector<double>& force, int substeps, size_t samples, size_t skip,
                 double sample_period_s, Drive drive) {
  Integrator run(rig);
  Motion m;
  m.x = m.v = m.a = std::vector<std::vector<double>>(run.n);
  m.damping_force.resize(run.links);
  m.hidden_force.resize(rig.effects.size());
  run.duration = static_cast<double>(samples) * sample_period_s;
  const double h = sample_period_s / substeps;
  std::vector<double> s(run.states, 0.0), d(run.states, 0.0);
  for (size_t sample = 0; sample < samples + skip; ++sample) {
    const double t0 = (static_cast<double>(sample) - static_cast<double>(skip)) * sample_period_s;
    const size_t base = sample * static_cast<size_t>(substeps) * 2;
    if (sample >= skip) {
      run.slope(s, t0, force[base], d);
      for (size_t i = 0; i < run.n; ++i)
        m.x[i].push_back(s[i]), m.v[i].push_back(s[run.n + i]), m.a[i].push_back(d[run.n + i]);
      for (size_t l = 0; l < run.links; ++l) {
        const double w = run.rate(s, l);
        const double slide = run.mode[l] == 0 ? run.hold[l] : run.mode[l] * rig.links[l].F;
        m.damping_force[l].push_back(rig.links[l].c * w + slide);
      }
      for (size_t i = 0; i < rig.effects.size(); ++i) m.hidden_force[i].push_back(run.hidden_force(i, s, t0, d));
    }
    for (int j = 0; j < substeps; ++j) {
      const size_t at = base + 2 * static_cast<size_t>(j), end = base + 2 * static_cast<size_t>(substeps);
      const auto between = [&](size_t i) {
        if (drive == Drive::kSmooth) return force[i];
        if (drive == Drive::kSteps) return force[base];
        return force[base] +
               (force[end] - force[base]) * static_cast<double>(i - base) / static_cast<double>(end - base);
      };
      run.substep(s, t0 + j * h, h, between(at), between(at + 1), between(at + 2));
    }
  }
  return m;
}

}  // namespace hidden
