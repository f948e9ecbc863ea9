// Events of the rig: rates that reach zero, links that let go, gaps that open or close.
#include <cmath>

#include "host_sim/plant/equations.hpp"

namespace host_sim {
namespace {

// A held link lets go a hair above its level, so that it then certainly moves off in the direction it is pulled.
constexpr double kReleaseMargin = 1e-10;
constexpr double kReserveGain = 10.0;  // makes that hair more than zero to the integrator

int sign_of(double value) { return (value > 0.0) - (value < 0.0); }

}  // namespace

void Equations::root_functions(double t_s, const double* y, const double* force, const Motion& base, const Modes& modes,
                               const MotionScale& scale, double* g) const {
  std::vector<size_t> held, held_root;
  size_t root = 0;
  for (size_t l = 0; l < links_.size(); ++l) {
    const PlantLink& link = links_[l];
    if (!link.watch_rate) continue;
    g[root] = (node(y, base, link.a).v - node(y, base, link.b).v) / scale.velocity;
    if (stuck(l, modes)) {
      held.push_back(l);
      held_root.push_back(root);
    }
    ++root;
  }
  if (!held.empty()) {
    std::vector<double> net(masses()), hold;
    net_forces(t_s, y, force, base, modes, net.data());
    unbounded_hold(net.data(), base, held, hold);
    for (size_t j = 0; j < held.size(); ++j)
      g[held_root[j]] = kReserveGain * (1.0 + kReleaseMargin - std::fabs(hold[j]) / links_[held[j]].hold);
  }
  gap_roots(y, base, scale, g + root);
}

void Equations::gap_roots(const double* y, const Motion& base, const MotionScale& scale, double* g) const {
  for (const PlantLink& link : links_)
    for (const EffectTerm& term : link.effects)
      if (term.shape == TermShape::kBacklash || term.shape == TermShape::kEndStop) {
        const double u = node(y, base, link.a).x - node(y, base, link.b).x;
        g[2 * term.index] = (u - term.p) / scale.displacement;
        g[2 * term.index + 1] = (u + term.p) / scale.displacement;
      }
}

std::vector<bool> Equations::apply_roots(const int* direction, Modes& modes) const {
  std::vector<bool> resting(links_.size(), false);
  size_t root = 0;
  for (size_t l = 0; l < links_.size(); ++l) {
    if (!links_[l].watch_rate) continue;
    const int d = direction[root++];
    if (links_[l].hold > 0.0)
      resting[l] = d != 0 || modes.rate_sign[l] == 0;
    else if (d != 0)
      modes.rate_sign[l] = d;
  }
  for (int& side : modes.gap_side) {
    const int upper = direction[root], lower = direction[root + 1];
    if (upper != 0) side = upper > 0 ? 1 : 0;
    if (lower != 0) side = lower < 0 ? -1 : 0;
    root += 2;
  }
  return resting;
}

Modes Equations::start_modes(double t_s, double* y, const double* force, const Motion& base) const {
  Modes modes{std::vector<int>(links_.size(), 1), std::vector<int>(gaps_, 0)};
  std::vector<bool> resting(links_.size(), false);
  for (size_t l = 0; l < links_.size(); ++l) {
    const Node a = node(y, base, links_[l].a), b = node(y, base, links_[l].b);
    const double u = a.x - b.x, w = a.v - b.v;
    resting[l] = w == 0.0 && links_[l].watch_rate && links_[l].hold > 0.0;
    modes.rate_sign[l] = sign_of(w);
    for (const EffectTerm& term : links_[l].effects)
      if (term.shape == TermShape::kBacklash || term.shape == TermShape::kEndStop)
        modes.gap_side[term.index] = u > term.p ? 1 : (u < -term.p ? -1 : 0);
  }
  solve_rest(t_s, y, force, base, resting, modes);
  std::vector<double> dy(states());
  derivative(t_s, y, force, base, modes, dy.data());
  for (size_t l = 0; l < links_.size(); ++l) {
    if (modes.rate_sign[l] != 0 || resting[l]) continue;
    const Motion base_rates{base.rate, base.acceleration, 0.0};
    const int s = sign_of(node(dy.data(), base_rates, links_[l].a).v - node(dy.data(), base_rates, links_[l].b).v);
    modes.rate_sign[l] = s == 0 ? 1 : s;
  }
  return modes;
}

bool Equations::resync(double* y, const Motion& base, Modes& modes) const {
  bool friction = false;
  for (size_t l = 0; l < links_.size(); ++l) {
    const Node a = node(y, base, links_[l].a), b = node(y, base, links_[l].b);
    const double u = a.x - b.x, w = a.v - b.v;
    if (links_[l].watch_rate && modes.rate_sign[l] * w < 0.0) {
      modes.rate_sign[l] = sign_of(w);
      friction |= links_[l].hold > 0.0;
    }
    for (const EffectTerm& term : links_[l].effects)
      if (term.shape == TermShape::kBacklash || term.shape == TermShape::kEndStop)
        modes.gap_side[term.index] = u > term.p ? 1 : (u < -term.p ? -1 : 0);
  }
  return friction;
}

}  // namespace host_sim
