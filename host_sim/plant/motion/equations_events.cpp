// Events of the rig: rates that reach zero, links that let go, gaps that open or close.
#include <cmath>

#include "host_sim/plant/motion/equations.hpp"

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
  each_gap(y, force, base, [&](const PlantTerm& term, double value, bool of_force) {
    vocabulary::Point at;
    at.u = value;
    for (int e = 0; e < 2; ++e)
      g[root + 2 * term.gap + static_cast<size_t>(e)] = vocabulary::event_function(term.kind, e, at, term.shape).value /
                                                        (of_force ? scale.force : scale.displacement);
  });
}

template <typename Visit>
void Equations::each_gap(const double* y, const double* force, const Motion& base, Visit visit) const {
  if (gaps_ == 0) return;
  const auto each = [&](const std::vector<PlantTerm>& terms, double value, bool of_force) {
    for (const PlantTerm& term : terms)
      if (firmware::row_of(term.kind).nature.events == firmware::Events::kGap) visit(term, value, of_force);
  };
  for (const PlantLink& link : links_) each(link.terms, node(y, base, link.a).x - node(y, base, link.b).x, false);
  for (size_t i = 0; i < masses(); ++i) each(on_dof_[i], y[i], false), each(on_drive_[i], force[i], true);
}

void Equations::find_gap_sides(const double* y, const double* force, const Motion& base, Modes& modes) const {
  each_gap(y, force, base, [&](const PlantTerm& term, double value, bool) {
    modes.gap_side[term.gap] = vocabulary::point(term.kind, value, 0.0, 0.0, term.shape).side;
  });
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
    const double w = node(y, base, links_[l].a).v - node(y, base, links_[l].b).v;
    resting[l] = w == 0.0 && links_[l].watch_rate && links_[l].hold > 0.0;
    modes.rate_sign[l] = sign_of(w);
  }
  find_gap_sides(y, force, base, modes);
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

bool Equations::resync(double* y, const double* force, const Motion& base, Modes& modes) const {
  bool friction = false;
  for (size_t l = 0; l < links_.size(); ++l) {
    const double w = node(y, base, links_[l].a).v - node(y, base, links_[l].b).v;
    if (links_[l].watch_rate && modes.rate_sign[l] * w < 0.0) {
      modes.rate_sign[l] = sign_of(w);
      friction |= links_[l].hold > 0.0;
    }
  }
  find_gap_sides(y, force, base, modes);
  return friction;
}

}  // namespace host_sim
