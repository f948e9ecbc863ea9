#include "host_sim/force_balance/force_balance.hpp"

#include <algorithm>
#include <cmath>

#include "hal/rig_file/effect_words.hpp"
#include "host_sim/force_balance/derivative.hpp"

namespace host_sim {
namespace {

using firmware::TermKind;

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
      return w * rig_file::drifted_s(t_s, shape);
    default:
      return 0.0;
  }
}

// The effect's force; the state of presliding_hysteresis goes along with the elongation.
Series effect_force(const rig_file::Effect& effect, const LinkBalance& link, bool rotates, double period_s) {
  const double shape = rig_file::first_shape(effect, rotates);
  const TermKind kind = rig_file::find_effect_word(effect.kind)->term;
  Series force(link.elongation.size());
  double dahl = 0.0;
  for (size_t i = 0; i < force.size(); ++i) {
    const double t_s = static_cast<double>(i + kDerivativeMargin) * period_s;
    if (kind == TermKind::kPreslidingHysteresis && i > 0) {
      // Dahl: dz = (1 - z sgn(du)) du / length, exact over a step
      const double step = (link.elongation[i] - link.elongation[i - 1]) / shape, end = sign(step);
      dahl = end + (dahl - end) * std::exp(-std::abs(step));
    }
    force[i] = effect.coefficient.value * effect_shape(kind, link.elongation[i], link.rate[i], t_s, shape, dahl);
  }
  return force;
}

LinkBalance link_balance(const rig_file::Link& link, const NodeMotion& a, const NodeMotion& b, bool rotates,
                         double period_s) {
  LinkBalance balance;
  const size_t count = a.x.size();
  for (size_t i = 0; i < count; ++i) {
    balance.elongation.push_back(a.x[i] - b.x[i]);
    balance.rate.push_back(a.v[i] - b.v[i]);
  }
  const std::string place = "[" + rig_file::link_label(link) + "]";
  const auto add = [&](const char* word, bool conservative, double coefficient, const Series& of, auto shape) {
    if (coefficient == 0.0) return;
    ForceTerm term{word + place, conservative, Series(count)};
    for (size_t i = 0; i < count; ++i) term.force[i] = coefficient * shape(of[i]);
    balance.terms.push_back(std::move(term));
  };
  const auto itself = [](double value) { return value; };
  add("stiffness", true, link.stiffness_N_m.value, balance.elongation, itself);
  add("viscous", false, link.viscous_N_s_m.value, balance.rate, itself);
  add("coulomb", false, link.coulomb_N.value, balance.rate, sign);
  add("gravity_torque", true, link.gravity_torque_N_m.value, balance.elongation, [](double u) { return std::sin(u); });
  for (const rig_file::Effect& effect : link.effects)
    balance.terms.push_back({effect.kind + place, false, effect_force(effect, balance, rotates, period_s)});
  return balance;
}

}  // namespace

Series LinkBalance::total() const {
  Series sum(elongation.size(), 0.0);
  for (const ForceTerm& term : terms)
    for (size_t i = 0; i < sum.size(); ++i) sum[i] += term.force[i];
  return sum;
}

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
    balance.drive.push_back(force != nullptr ? without_margins(force->values) : Series(count, 0.0));
    balance.reference.push_back(force != nullptr ? balance.drive.back() : inertia);
    balance.residual.push_back(balance.drive.back());
    for (size_t j = 0; j < count; ++j) balance.residual.back()[j] -= inertia[j];
    balance.inertia.push_back(std::move(inertia));
    balance.velocity.push_back(motions[i].v);
  }
  for (const rig_file::Link& link : rig.links) {
    const NodeMotion base = link.b == rig_file::kBase ? motion_of(record, rig_file::kBase) : fixed;
    const NodeMotion& a = motions[static_cast<size_t>(link.a - 1)];
    const NodeMotion& b = link.b > 0 ? motions[static_cast<size_t>(link.b - 1)] : base;
    balance.links.push_back(link_balance(link, a, b, rig_file::link_rotates(rig, link), record.sample_period_s));
    const Series force = balance.links.back().total();
    for (size_t j = 0; j < count; ++j) {
      balance.residual[static_cast<size_t>(link.a - 1)][j] -= force[j];
      if (link.b > 0) balance.residual[static_cast<size_t>(link.b - 1)][j] += force[j];
    }
  }
  return balance;
}

}  // namespace host_sim
