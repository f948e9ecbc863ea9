#include "host_sim/plant/equations.hpp"

#include <cmath>

#include "hal/rig_file/effect_words.hpp"

namespace host_sim {

Equations::Node Equations::node(const double* y, const Motion& base, size_t index) const {
  if (index < masses()) return {y[index], y[masses() + index]};
  if (index == base_node()) return {base.value, base.rate};
  return {0.0, 0.0};
}

double Equations::sliding_force(const PlantLink& link, size_t link_index, double t_s, double u, double w,
                                const double* z, const Modes& modes) const {
  const double s = modes.rate_sign[link_index];
  double f = link.k * u + link.c * w + link.coulomb * s;
  if (link.gravity != 0.0) f += link.gravity * std::sin(u);
  for (const EffectTerm& term : link.effects) {
    const double q = term.coefficient;
    switch (term.shape) {
      case TermShape::kCubicStiffness:
        f += q * u * u * u;
        break;
      case TermShape::kQuadraticStiffness:
        f += q * u * u;
        break;
      case TermShape::kBacklash: {
        const int side = modes.gap_side[term.index];
        f -= q * (side == 0 ? u : side * term.p);
        break;
      }
      case TermShape::kEndStop: {
        const int side = modes.gap_side[term.index];
        if (side != 0) f += q * (u - side * term.p);
        break;
      }
      case TermShape::kQuadraticDamping:
        f += q * w * w * s;
        break;
      case TermShape::kCubicDamping:
        f += q * w * w * w;
        break;
      case TermShape::kStribeck:
        f += q * s * std::exp(-s * w / term.p);
        break;
      case TermShape::kPresliding:
        f += q * z[term.index];
        break;
      case TermShape::kForceOffset:
        f += q;
        break;
      case TermShape::kAsymmetricViscous:
        f += q * w * s;
        break;
      case TermShape::kDisplacementDependent:
        f += q * u * u * w;
        break;
      case TermShape::kDrifting:
        f += q * w * rig_file::drifted_s(t_s, term.p);
        break;
    }
  }
  return f;
}

void Equations::net_forces(double t_s, const double* y, const double* force, const Motion& base, const Modes& modes,
                           double* net) const {
  for (size_t i = 0; i < masses(); ++i) net[i] = force[i];
  const double* z = y + 2 * masses();
  for (size_t l = 0; l < links_.size(); ++l) {
    const PlantLink& link = links_[l];
    const Node a = node(y, base, link.a), b = node(y, base, link.b);
    const double f = sliding_force(link, l, t_s, a.x - b.x, a.v - b.v, z, modes);
    if (link.a < masses()) net[link.a] -= f;
    if (link.b < masses()) net[link.b] += f;
  }
}

void Equations::accelerations(const double* net, const Motion& base, const Modes& modes, double* a) const {
  const std::vector<bool> joined = stuck_links(modes);
  if (joined.empty()) {
    for (size_t i = 0; i < masses(); ++i) a[i] = net[i] / mass_[i];
    return;
  }
  const std::vector<size_t> body = bodies(joined);
  std::vector<double> sum(masses() + 2, 0.0), inertia(masses() + 2, 0.0);
  for (size_t i = 0; i < masses(); ++i) {
    sum[body[i]] += net[i];
    inertia[body[i]] += mass_[i];
  }
  for (size_t i = 0; i < masses(); ++i) {
    if (body[i] == body[ground()])
      a[i] = 0.0;
    else if (body[i] == body[base_node()])
      a[i] = base.acceleration;
    else
      a[i] = sum[body[i]] / inertia[body[i]];
  }
}

void Equations::derivative(double t_s, const double* y, const double* force, const Motion& base, const Modes& modes,
                           double* dy) const {
  const size_t n = masses();
  net_forces(t_s, y, force, base, modes, dy + n);
  accelerations(dy + n, base, modes, dy + n);
  for (size_t i = 0; i < n; ++i) dy[i] = y[n + i];
  if (presliding_ == 0) return;
  for (size_t l = 0; l < links_.size(); ++l)
    for (const EffectTerm& term : links_[l].effects)
      if (term.shape == TermShape::kPresliding) {
        const double w = node(y, base, links_[l].a).v - node(y, base, links_[l].b).v;
        dy[2 * n + term.index] = w / term.p * (1.0 - y[2 * n + term.index] * modes.rate_sign[l]);
      }
}

std::vector<double> Equations::initial_state(const std::vector<double>& x, const std::vector<double>& v,
                                             const Motion& base) const {
  std::vector<double> y(states(), 0.0);
  for (size_t i = 0; i < dofs_; ++i) {
    y[i] = i < x.size() ? x[i] : 0.0;
    y[masses() + i] = i < v.size() ? v[i] : 0.0;
  }
  for (const PlantLink& link : links_)
    if (link.a >= dofs_ && link.a < masses()) {
      y[link.a] = y[link.b];
      y[masses() + link.a] = y[masses() + link.b];
    }
  for (const PlantLink& link : links_)
    for (const EffectTerm& term : link.effects)
      if (term.shape == TermShape::kPresliding) {
        const double w = node(y.data(), base, link.a).v - node(y.data(), base, link.b).v;
        y[2 * masses() + term.index] = w > 0.0 ? 1.0 : (w < 0.0 ? -1.0 : 0.0);
      }
  return y;
}

}  // namespace host_sim
