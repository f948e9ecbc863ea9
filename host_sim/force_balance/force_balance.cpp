#include "host_sim/force_balance/force_balance.hpp"

#include <algorithm>
#include <iterator>

#include "hal/rig_file/toml/effect_words.hpp"
#include "host_sim/force_balance/derivative.hpp"
#include "host_sim/vocabulary/law.hpp"

namespace host_sim {
namespace {

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

// The force of a law with its coefficient along a motion; what it remembers goes along from sample to sample.
Series force_of(firmware::EffectKind kind, double coefficient, const vocabulary::Shape& shape, const Series& u,
                const Series& w, double period_s) {
  Series force(u.size());
  vocabulary::Point before;
  double z[vocabulary::kMemories] = {};
  for (size_t i = 0; i < u.size(); ++i) {
    const double t_s = static_cast<double>(i + kDerivativeMargin) * period_s;
    vocabulary::Point at = vocabulary::point(kind, u[i], w[i], t_s, shape);
    if (i == 0)
      vocabulary::start_memory(kind, at, shape, z);
    else
      vocabulary::advance_memory(kind, before, at, period_s, shape, z);
    std::copy(std::begin(z), std::end(z), at.z);
    force[i] = coefficient * vocabulary::force(kind, at, shape).value;
    before = at;
  }
  return force;
}

vocabulary::Shape shape_of(const rig_file::Effect& effect, bool rotates) {
  vocabulary::Shape shape;
  for (int i = 0; i < vocabulary::kShapes; ++i) shape.p[i] = rig_file::shape_of(effect, i, rotates);
  return shape;
}

LinkBalance link_balance(const rig_file::Link& link, const NodeMotion& a, const NodeMotion& b, bool rotates,
                         double period_s) {
  using firmware::EffectKind;
  LinkBalance balance;
  for (size_t i = 0; i < a.x.size(); ++i) {
    balance.elongation.push_back(a.x[i] - b.x[i]);
    balance.rate.push_back(a.v[i] - b.v[i]);
  }
  const auto add = [&](const firmware::EffectRow& row, double coefficient, const vocabulary::Shape& shape) {
    if (coefficient == 0.0) return;
    balance.terms.push_back({row.word.text + ("[" + rig_file::link_label(link) + "]"), row.nature.conservative,
                             force_of(row.kind, coefficient, shape, balance.elongation, balance.rate, period_s)});
  };
  const auto own = [&](EffectKind kind, const rig_file::Coefficient& c) { add(firmware::row_of(kind), c.value, {}); };
  own(EffectKind::kStiffness, link.stiffness_N_m);
  own(EffectKind::kViscous, link.viscous_N_s_m);
  own(EffectKind::kCoulomb, link.coulomb_N);
  own(EffectKind::kGravityTorque, link.gravity_torque_N_m);
  for (const rig_file::Effect& effect : link.effects)
    if (const firmware::EffectRow* row = rig_file::find_effect_row(effect.kind))
      add(*row, effect.coefficient.value, shape_of(effect, rotates));
  return balance;
}

// What the effects of a DOF add to its mass, and the forces of the others: of a hidden resonance that it takes, of a drive
// that it does not get.
struct DofEffects {
  double mass = 0.0;
  Series force;
};

DofEffects dof_effects(const rig_file::Dof& dof, const NodeMotion& motion, const Series& drive, double period_s) {
  DofEffects sum{dof.mass_kg.value, Series(motion.x.size(), 0.0)};
  for (const rig_file::Effect& effect : dof.effects) {
    const firmware::EffectRow* row = rig_file::find_effect_row(effect.kind);
    if (row == nullptr) continue;
    if (row->role == firmware::EffectRole::kCorrection) {
      sum.mass += effect.coefficient.value;
      continue;
    }
    const bool of_drive = row->role == firmware::EffectRole::kDriveFault;
    const Series force = force_of(row->kind, effect.coefficient.value, shape_of(effect, dof.rotating),
                                  of_drive ? drive : motion.x, of_drive ? drive : motion.v, period_s);
    for (size_t j = 0; j < force.size(); ++j) sum.force[j] += force[j];
  }
  return sum;
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
    const Channel* force = record.find(Quantity::kForce, dof);
    balance.drive.push_back(force != nullptr ? without_margins(force->values) : Series(count, 0.0));
    const DofEffects effects = dof_effects(rig.dofs[i], motions[i], balance.drive.back(), record.sample_period_s);
    Series inertia(count);
    for (size_t j = 0; j < count; ++j) inertia[j] = effects.mass * motions[i].a[j];
    balance.reference.push_back(force != nullptr ? balance.drive.back() : inertia);
    balance.residual.push_back(balance.drive.back());
    for (size_t j = 0; j < count; ++j) balance.residual.back()[j] -= inertia[j] + effects.force[j];
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
