#include "integrator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "effect_force.hpp"

namespace hidden_rig {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr double kAtRest = 1e-5;  // of the fastest rate so far; a located reversal is far closer to rest
constexpr double kTrifle = 1e-12, kLoop = 1e-9;
constexpr int kMostEvents = 16;  // in one substep; what is left of it then runs through without

struct Inputs {  // at one instant
  std::vector<double> force;
  double base_x = 0, base_v = 0, base_a = 0;
};

class Integrator {
 public:
  Integrator(const TrueRig& rig, const Drive& drive, std::vector<double> viscous)
      : rig_(rig), drive_(drive), c_(std::move(viscous)), n_(rig.mass_kg.size()), links_(rig.links.size()) {
    states_ = 2 * n_;
    for (const TrueEffect& e : rig.effects) {
      law_.push_back(law_of(e.kind));
      memory_.push_back(states_);
      if (law_.back() == Law::kPreslidingHysteresis) states_ += 1;
      if (law_.back() == Law::kUnmodelledResonance) states_ += 2;
    }
    collect_friction();
    state_.assign(states_, 0.0);
    if (!drive.start_x.empty()) std::copy(drive.start_x.begin(), drive.start_x.end(), state_.begin());
    if (!drive.start_v.empty())
      std::copy(drive.start_v.begin(), drive.start_v.end(), state_.begin() + static_cast<long>(n_));
    for (auto* k : {&k1_, &k2_, &k3_, &k4_, &stage_, &next_}) k->assign(states_, 0.0);
    now_.force.assign(n_, 0.0);
    hold_.assign(links_, 0.0);
    inertia_ = rig.mass_kg;
    for (size_t e = 0; e < law_.size(); ++e)
      if (law_[e] == Law::kMassError) inertia_[static_cast<size_t>(rig.effects[e].dof)] += rig.effects[e].strength;
    mode_.assign(links_, 1);
    read_inputs(0, 0);
    for (size_t l = 0; l < links_; ++l) {
      const double w = rate(state_, l);
      mode_[l] = w > 0 ? 1 : (w < 0 ? -1 : 0);
      if (friction_level(l, 0) <= 0) mode_[l] = 1;
    }
  }

  void substep(size_t sample, int number);
  void record(size_t sample, bool keep, Motion& motion);
  double duration_s = 1, start_s = 0;

 private:
  double of(const std::vector<double>& s, int node, bool velocity) const {
    if (node >= 0) return s[static_cast<size_t>(node) + (velocity ? n_ : 0)];
    if (node == kToBase) return velocity ? now_.base_v : now_.base_x;
    return 0;
  }
  double elongation(const std::vector<double>& s, size_t l) const {
    return of(s, rig_.links[l].a, false) - of(s, rig_.links[l].b, false);
  }
  double rate(const std::vector<double>& s, size_t l) const {
    return of(s, rig_.links[l].a, true) - of(s, rig_.links[l].b, true);
  }
  void collect_friction() {
    level_.assign(links_, 0.0);
    stribeck_.assign(links_, nullptr);
    for (size_t l = 0; l < links_; ++l) level_[l] = rig_.links[l].F;
    for (size_t e = 0; e < law_.size(); ++e) {
      const TrueEffect& effect = rig_.effects[e];
      if (effect.link < 0) continue;
      const size_t l = static_cast<size_t>(effect.link);
      if (law_[e] == Law::kMissingCoulomb) level_[l] += effect.strength;
      if (law_[e] == Law::kStribeck) stribeck_[l] = &effect;
    }
    for (size_t e = 0; e < law_.size(); ++e)  // a Dahl or LuGre element stands in for all dry friction of its link
      if (law_[e] == Law::kPreslidingHysteresis) level_[static_cast<size_t>(rig_.effects[e].link)] = 0;
  }
  double friction_level(size_t l, double w) const {
    const TrueEffect* e = stribeck_[l];
    return level_[l] + (e != nullptr ? e->strength * std::exp(-std::abs(w) / e->shape) : 0.0);
  }
  // At the fraction r of a substep: quadratic through its three half substeps.
  static double between(const Values& v, size_t at, double r) {
    const double a = v[at], b = v[at + 1], c = v[at + 2];
    return a + r * (-3 * a + 4 * b - c) + 2 * r * r * (a - 2 * b + c);
  }
  void read_inputs(size_t at, double r) {
    for (size_t i = 0; i < drive_.force_N.size(); ++i) {
      if (drive_.force_N[i].empty()) continue;
      const size_t span = 2 * static_cast<size_t>(drive_.substeps);
      now_.force[i] = drive_.held ? drive_.force_N[i][at / span * span] : between(drive_.force_N[i], at, r);
    }
    for (size_t e = 0; e < law_.size(); ++e)
      if (law_[e] == Law::kDriveDeadBand) {
        double& f = now_.force[static_cast<size_t>(rig_.effects[e].dof)];
        f -= std::clamp(f, -rig_.effects[e].shape, rig_.effects[e].shape);
      }
    if (drive_.base_x.empty()) return;
    now_.base_x = between(drive_.base_x, at, r);
    now_.base_v = between(drive_.base_v, at, r);
    now_.base_a = between(drive_.base_a, at, r);
  }
  double link_force(size_t l, const std::vector<double>& s, double w) const {
    const TrueLink& link = rig_.links[l];
    const double u = elongation(s, l);
    return link.k * u + c_[l] * w + (link.G != 0 ? link.G * std::sin(u) : 0.0) + mode_[l] * friction_level(l, w);
  }
  double effect_force(size_t e, const std::vector<double>& s) const {
    const TrueEffect& effect = rig_.effects[e];
    if (effect.link < 0) return 0;
    const size_t l = static_cast<size_t>(effect.link);
    const double w = rate(s, l);
    if (law_[e] == Law::kPreslidingHysteresis) {
      const double z = s[memory_[e]];
      return rig_.links[l].F * (z + effect.shape2 * (w - std::abs(w) * z) / effect.shape);
    }
    return law_force(law_[e], effect, rig_.links[l].k, elongation(s, l), w, (time_s_ - start_s) / duration_s);
  }
  void add(size_t l, double f, double* push) const {
    if (rig_.links[l].a >= 0) push[rig_.links[l].a] -= f;
    if (rig_.links[l].b >= 0) push[rig_.links[l].b] += f;
  }
  void slope(const std::vector<double>& s, std::vector<double>& d);
  void turn_stuck();
  bool turn_answer(double trifle);
  void stop_stuck(double* motion, double base);
  void hold_stuck(double* acceleration);
  void bring_to_rest(std::vector<double>& s);
  void step(const std::vector<double>& s, size_t at, double from, double to, std::vector<double>& out);
  int event_link(const std::vector<double>& s);

  const TrueRig& rig_;
  const Drive& drive_;
  std::vector<double> c_;
  size_t n_, links_, states_;
  std::vector<Law> law_;
  std::vector<size_t> memory_;  // per effect: its first extra state
  std::vector<double> level_, inertia_, hold_;
  std::vector<const TrueEffect*> stribeck_;
  std::vector<int> mode_;  // per link: -1 or 1 sliding that way, 0 stuck
  std::vector<size_t> stuck_, stuck_now_;
  std::vector<double> answer_, gap_;  // of the stuck links' friction to their rates, row by row
  std::vector<double> state_, k1_, k2_, k3_, k4_, stage_, next_;
  Inputs now_;
  double time_s_ = 0, fastest_ = 0;
};

void Integrator::slope(const std::vector<double>& s, std::vector<double>& d) {
  for (size_t i = 0; i < n_; ++i) d[i] = s[n_ + i];
  double* push = &d[n_];
  for (size_t i = 0; i < n_; ++i) push[i] = now_.force[i];
  for (size_t l = 0; l < links_; ++l) add(l, link_force(l, s, rate(s, l)), push);
  for (size_t e = 0; e < law_.size(); ++e) {
    const TrueEffect& effect = rig_.effects[e];
    if (effect.link >= 0) add(static_cast<size_t>(effect.link), effect_force(e, s), push);
    const size_t z = memory_[e];
    if (law_[e] == Law::kPreslidingHysteresis) {
      const double w = rate(s, static_cast<size_t>(effect.link));
      d[z] = (w - std::abs(w) * s[z]) / effect.shape;
    }
    if (law_[e] == Law::kUnmodelledResonance) {
      const size_t j = static_cast<size_t>(effect.dof);
      const double omega = kTwoPi * effect.shape;
      const double a = omega * omega * (s[j] - s[z]) + 2 * effect.shape2 * omega * (s[n_ + j] - s[z + 1]);
      push[j] -= effect.strength * a;
      d[z] = s[z + 1];
      d[z + 1] = a;
    }
  }
  for (size_t i = 0; i < n_; ++i) push[i] /= inertia_[i];
  hold_stuck(push);
}

// Links that close a loop share what holds them alike: a trifle on the diagonal makes the shares' squares the least.
void Integrator::turn_stuck() {
  stuck_now_.clear();
  for (size_t l = 0; l < links_; ++l)
    if (mode_[l] == 0) stuck_now_.push_back(l);
  if (stuck_now_ == stuck_) return;
  stuck_ = stuck_now_;
  if (!turn_answer(0)) turn_answer(kTrifle);
}

// How the rates of stuck links answer to their friction, turned round. False: some links close a loop.
bool Integrator::turn_answer(double trifle) {
  const size_t n = stuck_.size();
  std::vector<double> a(n * n), whole;
  const auto sign = [&](size_t l, int dof) { return (rig_.links[l].a == dof) - (rig_.links[l].b == dof); };
  for (size_t i = 0; i < n; ++i)
    for (size_t j = 0; j < n; ++j)
      for (size_t dof = 0; dof < n_; ++dof)
        a[i * n + j] += sign(stuck_[i], static_cast<int>(dof)) * sign(stuck_[j], static_cast<int>(dof)) / inertia_[dof];
  answer_.assign(n * n, 0.0);
  for (size_t i = 0; i < n; ++i) {
    a[i * n + i] *= 1 + trifle;
    answer_[i * n + i] = 1;
    whole.push_back(a[i * n + i]);
  }
  for (size_t p = 0; p < n; ++p) {  // positive definite: no search for pivots
    if (trifle == 0 && a[p * n + p] < kLoop * whole[p]) return false;
    const double by = 1 / a[p * n + p];
    for (size_t j = 0; j < n; ++j) a[p * n + j] *= by, answer_[p * n + j] *= by;
    for (size_t i = 0; i < n; ++i) {
      const double factor = a[i * n + p];
      if (i == p) continue;
      for (size_t j = 0; j < n; ++j)
        a[i * n + j] -= factor * a[p * n + j], answer_[i * n + j] -= factor * answer_[p * n + j];
    }
  }
  return true;
}

// Takes from the DOFs' motion what would move stuck links against the motion of the base; the impulses are added to hold_. Twice: the
// second time for what rounding left.
void Integrator::stop_stuck(double* motion, double base) {
  const size_t n = stuck_.size();
  for (int pass = 0; pass < 2; ++pass) {
    gap_.assign(n, 0.0);
    for (size_t i = 0; i < n; ++i)
      for (const auto& [node, sign] : {std::pair(rig_.links[stuck_[i]].a, 1), std::pair(rig_.links[stuck_[i]].b, -1)})
        gap_[i] += sign * (node >= 0 ? motion[node] : (node == kToBase ? base : 0.0));
    for (size_t i = 0; i < n; ++i) {
      double impulse = 0;
      for (size_t j = 0; j < n; ++j) impulse += answer_[i * n + j] * gap_[j];
      const TrueLink& link = rig_.links[stuck_[i]];
      hold_[stuck_[i]] += impulse;
      if (link.a >= 0) motion[link.a] -= impulse / inertia_[static_cast<size_t>(link.a)];
      if (link.b >= 0) motion[link.b] += impulse / inertia_[static_cast<size_t>(link.b)];
    }
  }
}

// Friction of stuck links keeps their rates at zero.
void Integrator::hold_stuck(double* acceleration) {
  std::fill(hold_.begin(), hold_.end(), 0.0);
  turn_stuck();
  stop_stuck(acceleration, now_.base_a);
}

// Takes from stuck links the rates that locating their reversals left: of the wrong sign they would end the next slide.
void Integrator::bring_to_rest(std::vector<double>& s) {
  turn_stuck();
  stop_stuck(s.data() + n_, now_.base_v);
}

// From one fraction of the substep to another; leaves the inputs at its end.
void Integrator::step(const std::vector<double>& s, size_t at, double from, double to, std::vector<double>& out) {
  const double substep_s = drive_.sample_period_s / drive_.substeps, h = (to - from) * substep_s, t = time_s_;
  const auto stage = [&](const std::vector<double>& k, double share) {
    for (size_t i = 0; i < states_; ++i) stage_[i] = s[i] + share * h * k[i];
  };
  read_inputs(at, from);
  slope(s, k1_);
  time_s_ = t + 0.5 * h;
  read_inputs(at, 0.5 * (from + to));
  stage(k1_, 0.5);
  slope(stage_, k2_);
  stage(k2_, 0.5);
  slope(stage_, k3_);
  time_s_ = t + h;
  read_inputs(at, to);
  stage(k3_, 1.0);
  slope(stage_, k4_);
  for (size_t i = 0; i < states_; ++i) out[i] = s[i] + h / 6 * (k1_[i] + 2 * k2_[i] + 2 * k3_[i] + k4_[i]);
  time_s_ = t;
}

// A link that has reversed, or that its friction no longer holds; -1: none.
int Integrator::event_link(const std::vector<double>& s) {
  bool any_stuck = false;
  for (size_t l = 0; l < links_; ++l) {
    if (mode_[l] == 0) {
      any_stuck = true;
    } else if ((level_[l] > 0 || stribeck_[l] != nullptr) && mode_[l] * rate(s, l) < 0) {
      return static_cast<int>(l);
    }
  }
  if (!any_stuck) return -1;
  slope(s, k4_);
  for (size_t l = 0; l < links_; ++l)
    if (mode_[l] == 0 && std::abs(hold_[l]) > friction_level(l, 0)) return static_cast<int>(l);
  return -1;
}

void Integrator::substep(size_t sample, int number) {
  const size_t at = 2 * (sample * static_cast<size_t>(drive_.substeps) + static_cast<size_t>(number));
  const double substep_s = drive_.sample_period_s / drive_.substeps;
  const double begin_s = time_s_;
  for (size_t i = 0; i < n_; ++i) fastest_ = std::max(fastest_, std::abs(state_[n_ + i]));
  double from = 0;
  for (int events = 0; from < 1; ++events) {
    const auto advance = [&](double to) {
      step(state_, at, from, to, next_);
      return event_link(next_);
    };
    if (advance(1) < 0 || events == kMostEvents) break;
    double low = from, high = 1;  // no event, event
    for (int i = 0; i < 40 && high - low > 1e-9; ++i) {
      const double middle = 0.5 * (low + high);
      (advance(middle) < 0 ? low : high) = middle;
    }
    const int reversed = advance(high);
    state_ = next_;
    from = high;
    time_s_ = begin_s + from * substep_s;
    if (reversed < 0) continue;
    const size_t l = static_cast<size_t>(reversed);
    if (mode_[l] != 0 && std::abs(rate(state_, l)) > kAtRest * fastest_) {
      mode_[l] = rate(state_, l) > 0 ? 1 : -1;  // it slides the other way since before: too many events at once
      continue;
    }
    mode_[l] = 0;
    bring_to_rest(state_);
    slope(state_, k4_);
    if (std::abs(hold_[l]) > friction_level(l, 0)) mode_[l] = hold_[l] > 0 ? 1 : -1;
  }
  state_ = next_;
  time_s_ = begin_s + substep_s;
}

void Integrator::record(size_t sample, bool keep, Motion& m) {
  read_inputs(2 * sample * static_cast<size_t>(drive_.substeps), 0);
  if (!keep) return;
  slope(state_, k1_);
  for (size_t i = 0; i < n_; ++i) {
    m.x[i].push_back(state_[i]);
    m.v[i].push_back(state_[n_ + i]);
    m.a[i].push_back(k1_[n_ + i]);
  }
  for (size_t l = 0; l < links_; ++l) {
    const double w = rate(state_, l);
    const double slide = mode_[l] == 0 ? hold_[l] : mode_[l] * rig_.links[l].F;
    m.damping_force[l].push_back(c_[l] * w + slide);
    m.rate[l].push_back(w);
    if (mode_[l] == 0) m.stuck_share[l] += 1;
  }
  for (size_t e = 0; e < law_.size(); ++e) {
    const TrueEffect& effect = rig_.effects[e];
    double f = effect_force(e, state_);
    if (law_[e] == Law::kNone) continue;
    if (effect.link >= 0) {
      const size_t l = static_cast<size_t>(effect.link);
      const double w = rate(state_, l);
      if (law_[e] == Law::kStribeck) f = mode_[l] * effect.strength * std::exp(-std::abs(w) / effect.shape);
      if (law_[e] == Law::kMissingCoulomb) f = mode_[l] * effect.strength;
      if (law_[e] == Law::kPreslidingHysteresis) f -= rig_.links[l].F * (w > 0 ? 1 : -1);
    } else {
      const size_t j = static_cast<size_t>(effect.dof);
      if (law_[e] == Law::kMassError) f = effect.strength * k1_[n_ + j];
      if (law_[e] == Law::kUnmodelledResonance) f = effect.strength * k1_[memory_[e] + 1];
      if (law_[e] == Law::kDriveDeadBand) {
        const double wanted = drive_.force_N[j][2 * sample * static_cast<size_t>(drive_.substeps)];
        f = std::clamp(wanted, -effect.shape, effect.shape);
      }
    }
    m.hidden_force[e].push_back(f);
  }
}

}  // namespace

Motion integrate(const TrueRig& rig, const Drive& drive, size_t samples, size_t skip,
                 const std::vector<double>& viscous_scale) {
  std::vector<double> c;
  for (size_t l = 0; l < rig.links.size(); ++l)
    c.push_back(rig.links[l].c * (viscous_scale.empty() ? 1.0 : viscous_scale[l]));
  Integrator run(rig, drive, c);
  run.duration_s = static_cast<double>(samples) * drive.sample_period_s;
  run.start_s = static_cast<double>(skip) * drive.sample_period_s;
  Motion m;
  m.x = m.v = m.a = std::vector<Values>(rig.mass_kg.size());
  m.damping_force = m.rate = std::vector<Values>(rig.links.size());
  m.hidden_force.resize(rig.effects.size());
  m.stuck_share.assign(rig.links.size(), 0.0);
  for (size_t sample = 0; sample < samples + skip; ++sample) {
    run.record(sample, sample >= skip, m);
    for (int j = 0; j < drive.substeps; ++j) run.substep(sample, j);
  }
  for (double& share : m.stuck_share) share /= static_cast<double>(samples);
  return m;
}

}  // namespace hidden_rig
