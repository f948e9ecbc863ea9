#include "free_run.hpp"

#include <algorithm>
#include <cmath>

#include "../record/sharpen.hpp"
#include "host_sim/vocabulary/law.hpp"

namespace diagnosis {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr int kLeadInSteps = 8;

struct Simulator {
  const System& system;
  const std::vector<ActiveTerm>& model;
  const FusedRecord& record;
  size_t n;
  std::vector<double> inertia, x, v, last_a, push, mid_x, mid_v, next;
  std::vector<Series> drive;                     // force on each DOF, without what the model calls faults of its sensor
  std::vector<double> level, impulse;            // friction of each link
  std::vector<double> dahl, hidden_x, hidden_v;  // states per term

  Simulator(const System& s, const std::vector<ActiveTerm>& m, const FusedRecord& f, Eigen::Index from)
      : system(s),
        model(m),
        record(f),
        n(s.dofs()),
        inertia(n, 0.0),
        x(n),
        v(n),
        last_a(n),
        push(n),
        drive(f.force),
        level(s.links.size()),
        impulse(level.size()),
        dahl(m.size(), 0.0),
        hidden_x(m.size()),
        hidden_v(m.size()) {
    for (const ActiveTerm& t : model)
      if (t.term.kind == Kind::kMass || t.term.kind == Kind::kMassError)
        inertia[static_cast<size_t>(t.term.dof)] += t.value;
    for (const ActiveTerm& t : model)
      if (of_force_sensor(t.term.kind)) drive[static_cast<size_t>(t.term.dof)] -= t.value * term_force(t.term, f, {});
    for (size_t j = 0; j < n; ++j) {
      x[j] = f.motion[j].smooth_x[from], v[j] = f.motion[j].smooth_v[from], last_a[j] = f.motion[j].smooth_a[from];
    }
    for (size_t i = 0; i < model.size(); ++i) {
      const Term& t = model[i].term;
      if (t.kind == Kind::kResonance) {
        const size_t j = static_cast<size_t>(t.dof);
        hidden_x[i] = x[j], hidden_v[i] = v[j];
        lead_in(i, from);
      }
      if (t.kind == Kind::kPresliding) dahl[i] = rate(v, static_cast<size_t>(t.link)) < 0 ? -1 : 1;
    }
  }
  // the hidden mass has moved before the start: let it follow the record up to there
  void lead_in(size_t i, Eigen::Index from) {
    const size_t j = static_cast<size_t>(model[i].term.dof);
    const Eigen::Index begin = std::max<Eigen::Index>(0, from - static_cast<Eigen::Index>(3 / record.period_s));
    hidden_x[i] = record.motion[j].smooth_x[begin], hidden_v[i] = record.motion[j].smooth_v[begin];
    for (Eigen::Index k = begin; k < from; ++k)
      for (int step = 0; step < kLeadInSteps; ++step) {
        const double r = (step + 0.5) / kLeadInSteps;
        hidden_force(i, record.motion[j].smooth_x[k] * (1 - r) + record.motion[j].smooth_x[k + 1] * r,
                     record.motion[j].smooth_v[k] * (1 - r) + record.motion[j].smooth_v[k + 1] * r,
                     record.period_s / kLeadInSteps);
      }
  }
  double hidden_force(size_t i, double motion, double speed, double h) {
    const Term& t = model[i].term;
    const double omega = kTwoPi * t.shape;
    const double a = omega * omega * (motion - hidden_x[i]) + 2 * t.shape2 * omega * (speed - hidden_v[i]);
    hidden_v[i] += h * a;
    hidden_x[i] += h * hidden_v[i];
    return model[i].value * a;
  }
  double end(const std::vector<double>& values, int dof, double base) const {
    return dof > 0 ? values[static_cast<size_t>(dof - 1)] : dof == rig_file::kBase ? base : 0.0;
  }
  double base_x = 0, base_v = 0;
  double elongation(const std::vector<double>& p, size_t l) const {
    return end(p, system.links[l].a, base_x) - end(p, system.links[l].b, base_x);
  }
  double rate(const std::vector<double>& s, size_t l) const {
    return end(s, system.links[l].a, base_v) - end(s, system.links[l].b, base_v);
  }
  void pull(size_t l, double force) {
    if (system.links[l].a > 0) push[static_cast<size_t>(system.links[l].a - 1)] -= force;
    if (system.links[l].b > 0) push[static_cast<size_t>(system.links[l].b - 1)] += force;
  }
  // every force but friction at motion p, s; friction levels on the way
  void forces(const std::vector<double>& p, const std::vector<double>& s, double t_s, double h) {
    std::fill(level.begin(), level.end(), 0.0);
    for (size_t i = 0; i < model.size(); ++i) {
      const Term& t = model[i].term;
      const double q = model[i].value;
      if (t.kind == Kind::kMass || t.kind == Kind::kMassError || model[i].companion >= 0) continue;
      if (t.dof >= 0) {
        const size_t j = static_cast<size_t>(t.dof);
        if (t.kind == Kind::kResonance) push[j] -= hidden_force(i, p[j], s[j], h);
        continue;
      }
      const size_t l = static_cast<size_t>(t.link);
      const double u = elongation(p, l), w = rate(s, l), clip = std::clamp(u, -t.shape, t.shape);
      switch (t.kind) {
        case Kind::kCoulomb:
        case Kind::kMissingCoulomb:
          level[l] += q;
          break;
        case Kind::kStribeck:
          level[l] += q * std::exp(-std::abs(w) / t.shape);
          break;
        case Kind::kStiffness:
        case Kind::kStiffnessError:
          pull(l, q * u);
          break;
        case Kind::kViscous:
        case Kind::kMissingViscous:
          pull(l, q * w);
          break;
        case Kind::kGravity:
          pull(l, q * std::sin(u));
          break;
        case Kind::kCubicStiffness:
          pull(l, q * u * u * u);
          break;
        case Kind::kQuadraticStiffness:
          pull(l, q * u * u);
          break;
        case Kind::kBacklash:
          pull(l, (t.given ? -q : q) * clip);
          break;
        case Kind::kEndStop:
          pull(l, q * (u - clip));
          break;
        case Kind::kQuadraticDamping:
          pull(l, q * w * std::abs(w));
          break;
        case Kind::kCubicDamping:
          pull(l, q * w * w * w);
          break;
        case Kind::kForceOffset:
          pull(l, q);
          break;
        case Kind::kAsymmetricViscous:
          pull(l, q * std::abs(w));
          break;
        case Kind::kDisplacementDamping:
          pull(l, q * u * u * w);
          break;
        case Kind::kDriftingViscous:
          pull(l, q * w * vocabulary::drifted_s(t_s, t.shape));
          break;
        case Kind::kPresliding: {
          const double way = w < 0 ? -1 : 1;
          dahl[i] = way + (dahl[i] - way) * std::exp(-std::abs(w) * h / t.shape);
          pull(l, q * (dahl[i] + t.shape2 * (w - std::abs(w) * dahl[i]) / t.shape));
          if (!t.given) level[l] -= q;  // in place of Coulomb friction
          break;
        }
        default:
          break;
      }
    }
  }
  void step(Eigen::Index sample, double r, double h) {
    const double t_s = (static_cast<double>(sample) + r) * record.period_s;
    for (size_t j = 0; j < n; ++j) {
      const Series& f = drive[j];
      push[j] = f.size() ? f[sample] * (1 - r) + f[sample + 1] * r : 0;
    }
    if (record.motion[n].measured) {
      base_x = record.motion[n].x[sample] * (1 - r) + record.motion[n].x[sample + 1] * r;
      base_v = record.motion[n].v[sample] * (1 - r) + record.motion[n].v[sample + 1] * r;
    }
    mid_x = x, mid_v = v;
    for (size_t j = 0; j < n; ++j)
      mid_x[j] += 0.5 * h * v[j] + 0.125 * h * h * last_a[j], mid_v[j] += 0.5 * h * last_a[j];
    forces(mid_x, mid_v, t_s, h);
    next = v;
    for (size_t j = 0; j < n; ++j) next[j] += h * push[j] / inertia[j];
    std::fill(impulse.begin(), impulse.end(), 0.0);
    for (int sweep = 0; sweep < 12; ++sweep) {
      double moved = 0;
      for (size_t l = 0; l < level.size(); ++l) {
        if (level[l] <= 0) continue;
        const int a = system.links[l].a, b = system.links[l].b;
        const double ia = a > 0 ? 1 / inertia[static_cast<size_t>(a - 1)] : 0,
                     ib = b > 0 ? 1 / inertia[static_cast<size_t>(b - 1)] : 0;
        const double wanted = impulse[l] + rate(next, l) / (ia + ib), limit = h * level[l];
        const double change = std::clamp(wanted, -limit, limit) - impulse[l];
        impulse[l] += change;
        if (a > 0) next[static_cast<size_t>(a - 1)] -= change * ia;
        if (b > 0) next[static_cast<size_t>(b - 1)] += change * ib;
        moved = std::max(moved, std::abs(change) / limit);
      }
      if (moved < 1e-9) break;
    }
    for (size_t j = 0; j < n; ++j) {
      last_a[j] = (next[j] - v[j]) / h;
      x[j] += 0.5 * h * (v[j] + next[j]);
      v[j] = next[j];
    }
  }
};

}  // namespace

FreeRun free_run(const System& system, const std::vector<ActiveTerm>& model, const FusedRecord& f, Eigen::Index from,
                 Eigen::Index to, int steps) {
  Simulator run(system, model, f, from);
  FreeRun out;
  out.x = out.v = out.a = std::vector<Series>(run.n, Series::Zero(to - from));
  for (Eigen::Index i = from; i < to; ++i) {
    for (size_t j = 0; j < run.n; ++j) {
      out.x[j][i - from] = run.x[j], out.v[j][i - from] = run.v[j], out.a[j][i - from] = run.last_a[j];
      out.finite = out.finite && std::isfinite(run.x[j]) && std::abs(run.x[j]) < 1e6;
    }
    if (!out.finite || i + 1 >= to) break;
    for (int part = 0; part < steps; ++part) run.step(i, (part + 0.5) / steps, f.period_s / steps);
  }
  return out;
}

}  // namespace diagnosis
