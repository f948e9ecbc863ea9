// Which effects make sense beside a model.
#include <algorithm>
#include <cmath>

#include "../motion/link_motion.hpp"
#include "../windows/windows.hpp"
#include "candidates.hpp"
#include "hal/rig_file/toml/effect_words.hpp"
#include "host_sim/vocabulary/held_in_place.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kLargeAngle = 0.2;     // rad: below it a pendulum is a spring
constexpr double kPitchesOfASwing = 8;  // of a cogging, on the way from the middle to the farthest point
constexpr double kPitchesOfAWay = 40;   // where no spring holds the link in place
constexpr double kPitchStep = 0.3;      // pitches nearer than that look alike

struct Extent {
  double u_peak = 0, u_rms = 0, w_rms = 0;
  double way = 0;  // from the lowest to the highest elongation
};

Extent extent_of(const System& s, const std::vector<Prepared>& records, size_t link) {
  Extent e;
  for (const Prepared& p : records) {
    for (bool rate : {false, true}) {
      const Vec d = motion_of(s.links[link], p, rate ? &Guess::v : &Guess::x);
      const double rms = std::sqrt(d.squaredNorm() / static_cast<double>(d.size()));
      if (rate)
        e.w_rms = std::max(e.w_rms, rms);
      else
        e.u_rms = std::max(e.u_rms, rms), e.u_peak = std::max(e.u_peak, d.cwiseAbs().maxCoeff()),
        e.way = std::max(e.way, d.maxCoeff() - d.minCoeff());
    }
  }
  return e;
}

// After a turn a shaft is where it was: without a spring nothing there depends on the angle, but what repeats.
bool turns_freely(const System& s, size_t link, const Extent& e) {
  return rig_file::link_rotates(s.rig, s.links[link]) && e.way > kTwoPi;
}

int find(const Model& model, int link, std::initializer_list<Kind> kinds) {
  for (size_t i = 0; i < model.size(); ++i)
    if (model[i].term.link == link && std::find(kinds.begin(), kinds.end(), model[i].term.kind) != kinds.end())
      return static_cast<int>(i);
  return -1;
}

bool has_known(const Model& model, Kind kind, int link) {
  const int at = find(model, link, {kind});
  return at >= 0 && model[static_cast<size_t>(at)].known;
}

}  // namespace

double way_of(const System& s, const std::vector<Prepared>& records, int link) {
  return extent_of(s, records, static_cast<size_t>(link)).way;
}

double rate_of(const System& s, const std::vector<Prepared>& records, int link) {
  return extent_of(s, records, static_cast<size_t>(link)).w_rms;
}

std::vector<Candidate> candidates_beside(const System& s, const Model& model, const std::vector<Prepared>& records,
                                         bool periodic_too) {
  std::vector<Candidate> list;
  const auto has = [&](const Term& t) {
    return std::any_of(model.begin(), model.end(), [&](const ModelTerm& m) { return m.term.same_place(t); });
  };
  const auto add = [&](std::vector<Term> terms, int complexity, int sign = 0, int host = -1) {
    if (!has(terms[0])) list.push_back({std::move(terms), host, sign, complexity});
  };
  const bool held = vocabulary::held_in_place(s.rig);
  double duration_s = 0, fastest_Hz = 0, slowest_s = 0;
  for (const Prepared& p : records) {
    duration_s = std::max(duration_s, p.time_s(p.samples)), fastest_Hz = std::max(fastest_Hz, p.top_Hz);
    slowest_s = std::max(slowest_s, p.period_s);
  }
  const bool scale_known =
      std::any_of(model.begin(), model.end(), [](const ModelTerm& t) { return t.known && !t.added && t.value != 0; });
  const bool based = records[0].guess.back().given, driven = based || forced(records);
  if (based) add({Term{Kind::kBaseDelay}}, 0);
  for (size_t i = 0; i < s.links.size(); ++i) {
    const int l = static_cast<int>(i);
    const bool listed = i < s.known_links || find(model, l, {Kind::kMissingViscous, Kind::kMissingCoulomb}) >= 0;
    if (records[0].base.ridden && (s.links[i].a == rig_file::kGround || s.links[i].b == rig_file::kGround))
      continue;  // where the ground is, accelerations do not say
    const Extent e = extent_of(s, records, i);
    if (e.w_rms <= 0) continue;
    const int viscous = find(model, l, {Kind::kViscous, Kind::kMissingViscous});
    const int friction = find(model, l, {Kind::kCoulomb, Kind::kMissingCoulomb});
    const int spring = find(model, l, {Kind::kStiffness});
    const bool hysteretic = find(model, l, {Kind::kPresliding}) >= 0;
    if (viscous < 0 || model[static_cast<size_t>(viscous)].known)
      add({on_link(Kind::kMissingViscous, l)}, 0, viscous < 0 ? 1 : 0);
    if (!hysteretic && (friction < 0 || model[static_cast<size_t>(friction)].known))
      add({on_link(Kind::kMissingCoulomb, l)}, 0, friction < 0 ? 1 : 0);
    if (!listed && spring < 0) add({on_link(Kind::kStiffnessError, l)}, 0, 1);  // a hose, a cable, a beam
    if (!listed) continue;
    const bool turns = spring < 0 && turns_freely(s, i, e);
    if (!turns && (spring < 0 || model[static_cast<size_t>(spring)].known)) add({on_link(Kind::kStiffnessError, l)}, 0);
    for (Kind k : {Kind::kForceOffset, Kind::kAsymmetricViscous, Kind::kQuadraticDamping, Kind::kCubicDamping})
      add({on_link(k, l)}, 0);
    if (!turns)
      for (Kind k : {Kind::kCubicStiffness, Kind::kQuadraticStiffness, Kind::kDisplacementDamping})
        add({on_link(k, l)}, 0);
    // what depends on the amplitude explains a decay as a drift in time does, and is the likelier story
    add({on_link(Kind::kDriftingViscous, l)}, 1);
    for (double share : {0.06, 0.2, 0.6}) add({on_link(Kind::kDriftingViscous, l, share * duration_s)}, 2);
    if (spring >= 0)
      for (double share : {0.001, 0.003, 0.01, 0.03, 0.1, 0.25, 0.5}) {
        add({on_link(Kind::kBacklash, l, share * e.u_peak)}, 1, 1, spring);
      }
    for (double share : {0.2, 0.35, 0.5, 0.62, 0.74, 0.85, 0.93})
      if (!turns) add({on_link(Kind::kEndStop, l, share * e.u_peak)}, 1, 1);
    if (!hysteretic)
      for (double share : {0.05, 0.12, 0.3, 0.7}) add({on_link(Kind::kStribeck, l, share * e.w_rms)}, 1, 1);
    if (rig_file::link_rotates(s.rig, s.links[i]) && s.links[i].b == rig_file::kGround &&
        find(model, l, {Kind::kGravity}) < 0 && e.u_peak > kLargeAngle)
      add({on_link(Kind::kMissingGravity, l)}, 0, 1);
    if (periodic_too) {
      const double most = held ? kPitchesOfASwing : kPitchesOfAWay;
      for (double pitches = 1; pitches < most; pitches += kPitchStep) {
        Term sine = on_link(Kind::kCogging, l, 0.5 * e.way / pitches), cosine = sine;
        cosine.shape2 = 0.25 * kTwoPi;
        add({sine, cosine}, 2);
      }
    }
    for (double share : {0.003, 0.01, 0.03, 0.1, 0.25, 0.6, 1.2})
      add({on_link(Kind::kPresliding, l, share * e.u_rms)}, 1, 1, friction);
  }
  for (size_t d = 0; d < s.dofs(); ++d) {
    const int dof = static_cast<int>(d);
    const int mass = [&] {
      for (size_t i = 0; i < model.size(); ++i)
        if (model[i].term.kind == Kind::kMass && model[i].term.dof == dof) return static_cast<int>(i);
      return -1;
    }();
    if (mass >= 0 && model[static_cast<size_t>(mass)].known) add({on_dof(Kind::kMassError, dof)}, 0);
    if (mass >= 0) {
      const double low = 0.7 / slowest_s, high = 1.4 * fastest_Hz;
      for (int i = 0; i < 24 && high > low; ++i) {
        const double hertz = low * std::pow(high / low, i / 23.0);
        add({on_dof(Kind::kResonance, dof, hertz, 0.02)}, 2, 1);
      }
    }
    const bool forced = records[0].force[d].size() > 0;
    if (forced) {
      if (massless(model)) add({on_dof(Kind::kMassError, dof)}, 0);  // between the load cell and the link
      if (scale_known && mass >= 0) add({on_dof(Kind::kForceGain, dof)}, 0);
      add({on_dof(Kind::kForceDelay, dof)}, 0);
      double rms = 0, noise = 0;
      for (const Prepared& p : records)
        if (p.force[d].size()) {
          rms = std::max(rms, std::sqrt(p.force[d].squaredNorm() / static_cast<double>(p.force[d].size())));
          noise = std::max(noise, noise_of_force(p, d));
        }
      if (mass >= 0 && rms > 0)
        for (double share = 0.02; share < 1.2; share *= 1.35)
          if (share * rms > kNoiseReaches * noise) add({on_dof(Kind::kDeadBand, dof, share * rms)}, 1, 1);
    }
    for (int q = 0; q < 3 && mass >= 0; ++q) {
      if (!trace_of(records[0], dof, q)) continue;
      Term gain = on_dof(Kind::kChannelGain, dof), delay = on_dof(Kind::kChannelDelay, dof);
      gain.quantity = delay.quantity = q;
      const bool others = records[0].traces.size() > 1;
      if (scale_known || others) add({gain}, 0);
      // late against what? a free motion that one channel tells is the same motion a little later
      if (others || (scale_known && driven)) add({delay}, 0);
    }
  }
  return list;
}

Model joined(const Model& model, const Candidate& c, const std::vector<double>& value) {
  Model out = model;
  for (size_t i = 0; i < c.terms.size(); ++i) {
    ModelTerm t;
    t.term = c.terms[i], t.known = false, t.added = true, t.host = c.host;
    t.value = i < value.size() ? value[i] : 0;
    if (t.term.kind == Kind::kCogging && value.size() == 2) {  // amplitude and phase of sine and cosine
      t.value = std::hypot(value[0], value[1]);
      if (t.value > 0) t.term.shape2 = std::atan2(value[1], value[0]);
      i = c.terms.size();
    }
    t.corrects = (t.term.kind == Kind::kMissingViscous && has_known(model, Kind::kViscous, t.term.link)) ||
                 (t.term.kind == Kind::kMissingCoulomb && has_known(model, Kind::kCoulomb, t.term.link));
    if (positive(t.term.kind) && !t.corrects && t.value <= 0) t.value = 1e-3 * std::abs(t.value) + 1e-12;
    const Kind k = t.term.kind;
    t.shape_free = k == Kind::kBacklash || k == Kind::kEndStop || k == Kind::kStribeck || k == Kind::kPresliding ||
                   k == Kind::kResonance || k == Kind::kCogging || k == Kind::kDeadBand ||
                   (k == Kind::kDriftingViscous && t.term.shape > 0);
    t.shape2_free = k == Kind::kCogging || (k == Kind::kPresliding && t.term.shape2 > 0);
    if (t.host >= 0) t.value = out[static_cast<size_t>(t.host)].value;
    out.push_back(t);
  }
  return out;
}

}  // namespace diagnosis::runs
