// Events of the rig: rates that reach zero, links that stick or let go, gaps that open or close.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "host_sim/plant/equations.hpp"

namespace host_sim {
namespace {

// A held link lets go a hair above its level, so that it then certainly moves off in the direction it is pulled.
constexpr double kReleaseMargin = 1e-10;
constexpr int kMaxSweeps = 2000;

int sign_of(double value) { return (value > 0.0) - (value < 0.0); }

}  // namespace

// Masses and fixed nodes that joined links tie together get the same number.
std::vector<size_t> Equations::bodies(const std::vector<bool>& joined) const {
  std::vector<size_t> body(masses() + 2);
  std::iota(body.begin(), body.end(), size_t{0});
  for (size_t l = 0; l < links_.size(); ++l) {
    if (!joined[l]) continue;
    const size_t from = body[links_[l].a], to = body[links_[l].b];
    std::replace(body.begin(), body.end(), from, to);
  }
  return body;
}

// What each of the given links must carry beyond its sliding force so that its rate stays zero, bounded by its hold:
// projected Gauss-Seidel on A h = b, A = B'M^-1 B, b = relative acceleration without hold; exact where no bound is
// active.
void Equations::hold_forces(const double* net, const Motion& base, const std::vector<size_t>& at_rest,
                            std::vector<double>& hold) const {
  hold.assign(at_rest.size(), 0.0);
  std::vector<double> a(masses() + 2, 0.0);
  for (size_t i = 0; i < masses(); ++i) a[i] = net[i] / mass_[i];
  a[base_node()] = base.acceleration;
  const auto mobility = [&](size_t node_index) { return node_index < masses() ? 1.0 / mass_[node_index] : 0.0; };
  double largest = 0.0;
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    double change = 0.0;
    for (size_t j = 0; j < at_rest.size(); ++j) {
      const PlantLink& link = links_[at_rest[j]];
      const double ma = mobility(link.a), mb = mobility(link.b);
      const double level = std::max(0.0, link.hold);
      const double next = std::clamp(hold[j] + (a[link.a] - a[link.b]) / (ma + mb), -level, level);
      const double step = next - hold[j];
      a[link.a] -= step * ma;
      a[link.b] += step * mb;
      hold[j] = next;
      change = std::max(change, std::fabs(step));
      largest = std::max(largest, std::fabs(next));
    }
    if (change <= 1e-15 * largest || at_rest.size() == 1) return;
  }
}

void Equations::solve_rest(double t_s, double* y, const double* force, const Motion& base,
                           const std::vector<bool>& resting, Modes& modes) const {
  std::vector<size_t> at_rest;
  for (size_t l = 0; l < links_.size(); ++l)
    if (resting[l]) at_rest.push_back(l);
  if (at_rest.empty()) return;
  for (size_t l : at_rest) modes.rate_sign[l] = 0;
  equalise(y, base, modes);
  std::vector<double> net(masses()), hold;
  net_forces(t_s, y, force, base, modes, net.data());
  hold_forces(net.data(), base, at_rest, hold);
  for (size_t j = 0; j < at_rest.size(); ++j)
    if (std::fabs(hold[j]) >= links_[at_rest[j]].hold) modes.rate_sign[at_rest[j]] = sign_of(hold[j]);
}

void Equations::equalise(double* y, const Motion& base, const Modes& modes) const {
  std::vector<bool> joined(links_.size(), false);
  bool any = false;
  for (size_t l = 0; l < links_.size(); ++l) {
    joined[l] = links_[l].watch_rate && links_[l].hold > 0.0 && modes.rate_sign[l] == 0;
    any |= joined[l];
  }
  if (!any) return;
  const std::vector<size_t> body = bodies(joined);
  double* v = y + masses();
  std::vector<double> momentum(masses() + 2, 0.0), inertia(masses() + 2, 0.0);
  for (size_t i = 0; i < masses(); ++i) {
    momentum[body[i]] += mass_[i] * v[i];
    inertia[body[i]] += mass_[i];
  }
  for (size_t i = 0; i < masses(); ++i) {
    if (body[i] == body[ground()])
      v[i] = 0.0;
    else if (body[i] == body[base_node()])
      v[i] = base.rate;
    else
      v[i] = momentum[body[i]] / inertia[body[i]];
  }
}

void Equations::root_functions(double t_s, const double* y, const double* force, const Motion& base, const Modes& modes,
                               double* g) const {
  std::vector<size_t> stuck;
  size_t root = 0;
  for (size_t l = 0; l < links_.size(); ++l) {
    const PlantLink& link = links_[l];
    if (!link.watch_rate) continue;
    g[root] = node(y, base, link.a).v - node(y, base, link.b).v;
    if (link.hold > 0.0 && modes.rate_sign[l] == 0) stuck.push_back(l);
    ++root;
  }
  if (!stuck.empty()) {
    std::vector<double> net(masses()), hold;
    net_forces(t_s, y, force, base, modes, net.data());
    unbounded_hold(net.data(), base, stuck, hold);
    root = 0;
    size_t next = 0;
    for (size_t l = 0; l < links_.size(); ++l) {
      if (!links_[l].watch_rate) continue;
      if (next < stuck.size() && stuck[next] == l) {
        g[root] = links_[l].hold * (1.0 + kReleaseMargin) - std::fabs(hold[next]);
        ++next;
      }
      ++root;
    }
  }
  gap_roots(y, base, g + root);
}

void Equations::unbounded_hold(const double* net, const Motion& base, const std::vector<size_t>& stuck,
                               std::vector<double>& hold) const {
  const auto acceleration = [&](size_t i) {
    return i < masses() ? net[i] / mass_[i] : (i == base_node() ? base.acceleration : 0.0);
  };
  const auto mobility = [&](size_t i) { return i < masses() ? 1.0 / mass_[i] : 0.0; };
  const Eigen::Index n = static_cast<Eigen::Index>(stuck.size());
  Eigen::MatrixXd matrix(n, n);  // A D, D = diag(sqrt(hold))
  Eigen::VectorXd b(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const PlantLink& li = links_[stuck[static_cast<size_t>(i)]];
    b(i) = acceleration(li.a) - acceleration(li.b);
    for (Eigen::Index j = 0; j < n; ++j) {
      const PlantLink& lj = links_[stuck[static_cast<size_t>(j)]];
      const auto incidence = [&lj](size_t node_index) {
        return (lj.a == node_index ? 1.0 : 0.0) - (lj.b == node_index ? 1.0 : 0.0);
      };
      matrix(i, j) = (mobility(li.a) * incidence(li.a) - mobility(li.b) * incidence(li.b)) * std::sqrt(lj.hold);
    }
  }
  hold.resize(stuck.size());
  if (n == 1) {
    hold[0] = b(0) / matrix(0, 0) * std::sqrt(links_[stuck[0]].hold);
    return;
  }
  const Eigen::VectorXd solution = matrix.completeOrthogonalDecomposition().solve(b);
  for (size_t j = 0; j < stuck.size(); ++j)
    hold[j] = solution(static_cast<Eigen::Index>(j)) * std::sqrt(links_[stuck[j]].hold);
}

void Equations::gap_roots(const double* y, const Motion& base, double* g) const {
  for (const PlantLink& link : links_)
    for (const EffectTerm& term : link.effects)
      if (term.shape == TermShape::kBacklash || term.shape == TermShape::kEndStop) {
        const double u = node(y, base, link.a).x - node(y, base, link.b).x;
        g[2 * term.index] = u - term.p;
        g[2 * term.index + 1] = u + term.p;
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

bool Equations::any_stuck(const Modes& modes) const {
  for (size_t l = 0; l < links_.size(); ++l)
    if (links_[l].watch_rate && links_[l].hold > 0.0 && modes.rate_sign[l] == 0) return true;
  return false;
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
