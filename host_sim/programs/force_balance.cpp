#include "host_sim/programs/force_balance.hpp"

#include <algorithm>
#include <cmath>

#include "hal/configuration/effect_words.hpp"
#include "host_sim/programs/derivative.hpp"

namespace host_sim {
namespace {

using firmware::TermKind;
using Series = std::vector<double>;

Series integral(const Series& rate, double period_s) {
  Series result(rate.size(), 0.0);
  for (size_t i = 1; i < rate.size(); ++i) result[i] = result[i - 1] + 0.5 * period_s * (rate[i - 1] + rate[i]);
  return result;
}

struct NodeMotion {
  Series x, v, a;  // without margins
};

NodeMotion motion_of(const Record& record, int dof) {
  const double period_s = record.sample_period_s;
  const Channel* x = record.find(Quantity::kDisplacement, dof);
  const Channel* v = record.find(Quantity::kVelocity, dof);
  const Channel* a = record.find(Quantity::kAcceleration, dof);
  const size_t count = record.samples();
  Series velocity, displacement = x != nullptr ? x->values : Series(count, 0.0);
  if (v != nullptr)
    velocity = v->values;
  else if (x == nullptr && a != nullptr)
    velocity = integral(a->values, period_s);
  if (x == nullptr && !velocity.empty()) displacement = integral(velocity, period_s);
  NodeMotion motion;
  motion.x = without_margins(displacement);
  motion.v = velocity.empty() ? first_derivative(displacement, period_s) : without_margins(velocity);
  if (a != nullptr)
    motion.a = without_margins(a->values);
  else
    motion.a = velocity.empty() ? second_derivative(displacement, period_s) : first_derivative(velocity, period_s);
  return motion;
}

double sign(double value) { return static_cast<double>(value > 0.0) - static_cast<double>(value < 0.0); }

// Force per unit coefficient; dahl is the state of presliding_hysteresis, -1 to 1.
double effect_shape(TermKind kind, double u, double w, double t_s, double shape, double dahl) {
  switch (kind) {
    case TermKind::kStiffness:
      return u;
    case TermKind::kViscous:
      return w;
    case TermKind::kCoulomb:
      return sign(w);
    case TermKind::kCubicStiffness:
      return u * u * u;
    case TermKind::kQuadraticStiffness:
      return u * u;
    case TermKind::kBacklash:
      return -std::clamp(u, -shape, shape);
    case TermKind::kEndStop:
      return u - std::clamp(u, -shape, shape);
    case TermKind::kQuadraticDamping:
      return w * std::abs(w);
    case TermKind::kCubicDamping:
      return w * w * w;
    case TermKind::kStribeck:
      return std::exp(-std::abs(w) / shape) * sign(w);
    case TermKind::kPreslidingHysteresis:
      return dahl;
    case TermKind::kForceOffset:
      return 1.0;
    case TermKind::kAsymmetricViscous:
      return std::abs(w);
    case TermKind::kDisplacementDependentDamping:
      return u * u * w;
    case TermKind::kDriftingViscous:
      return w * t_s;
    default:
      return 0.0;
  }
}

Series link_force(const rig_file::Link& link, const NodeMotion& a, const NodeMotion& b, bool rotates, double period_s) {
  Series force(a.x.size());
  double dahl = 0.0, previous_u = 0.0;
  for (size_t i = 0; i < force.size(); ++i) {
    const double u = a.x[i] - b.x[i], w = a.v[i] - b.v[i];
    const double t_s = static_cast<double>(i + kDerivativeMargin) * period_s;
    force[i] = link.stiffness_N_m.value * u + link.viscous_N_s_m.value * w + link.coulomb_N.value * sign(w) +
               link.gravity_torque_N_m.value * std::sin(u);
    for (const rig_file::Effect& effect : link.effects) {
      const double shape = rig_file::first_shape(effect, rotates);
      const TermKind kind = rig_file::find_effect_word(effect.kind)->term;
      if (kind == TermKind::kPreslidingHysteresis) {
        const double step =
            i == 0 ? 0.0 : (u - previous_u) / shape;  // Dahl: dz = (1 - z sgn(du)) du / length, exact over a step
        const double end = sign(step);
        dahl = end + (dahl - end) * std::exp(-std::abs(step));
      }
      force[i] += effect.coefficient.value * effect_shape(kind, u, w, t_s, shape, dahl);
    }
    previous_u = u;
  }
  return force;
}

}  // namespace

ForceBalance force_balance(const rig_file::RigModel& rig, const Record& record) {
  const size_t count = record.samples() - 2 * kDerivativeMargin;
  const NodeMotion fixed{Series(count, 0.0), Series(count, 0.0), Series(count, 0.0)};
  std::vector<NodeMotion> motions;
  ForceBalance balance;
  for (size_t i = 0; i < rig.dofs.size(); ++i) {
    const int dof = static_cast<int>(i + 1);
    motions.push_back(motion_of(record, dof));
    double mass = rig.dofs[i].mass_kg.value;
    for (const rig_file::Effect& effect : rig.dofs[i].effects)
      if (effect.kind == "mass_error") mass += effect.coefficient.value;
    Series inertia(count);
    for (size_t j = 0; j < count; ++j) inertia[j] = mass * motions[i].a[j];
    const Channel* force = record.find(Quantity::kForce, dof);
    balance.reference.push_back(force != nullptr ? without_margins(force->values) : inertia);
    balance.residual.push_back(force != nullptr ? balance.reference.back() : Series(count, 0.0));
    for (size_t j = 0; j < count; ++j) balance.residual.back()[j] -= inertia[j];
  }
  for (const rig_file::Link& link : rig.links) {
    const NodeMotion base = link.b == rig_file::kBase ? motion_of(record, rig_file::kBase) : fixed;
    const NodeMotion& a = motions[static_cast<size_t>(link.a - 1)];
    const NodeMotion& b = link.b > 0 ? motions[static_cast<size_t>(link.b - 1)] : base;
    const Series force = link_force(link, a, b, rig_file::link_rotates(rig, link), record.sample_period_s);
    for (size_t j = 0; j < count; ++j) {
      balance.residual[static_cast<size_t>(link.a - 1)][j] -= force[j];
      if (link.b > 0) balance.residual[static_cast<size_t>(link.b - 1)][j] += force[j];
    }
  }
  return balance;
}

}  // namespace host_sim
