// Links at rest: which of them hold, what they carry, and the bodies that they tie together.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "host_sim/plant/motion/equations.hpp"

namespace host_sim {
namespace {

constexpr int kMostSweeps = 2000;

}  // namespace

std::vector<bool> Equations::stuck_links(const Modes& modes) const {
  std::vector<bool> joined;
  for (size_t l = 0; l < links_.size(); ++l) {
    if (!stuck(l, modes)) continue;
    joined.resize(links_.size(), false);
    joined[l] = true;
  }
  return joined;
}

std::vector<size_t> Equations::stuck_bodies(const Modes& modes) const {
  const std::vector<bool> joined = stuck_links(modes);
  return joined.empty() ? std::vector<size_t>() : bodies(joined);
}

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
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
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
    if (std::fabs(hold[j]) >= links_[at_rest[j]].hold) modes.rate_sign[at_rest[j]] = hold[j] > 0.0 ? 1 : -1;
}

void Equations::equalise(double* y, const Motion& base, const Modes& modes) const {
  const std::vector<bool> joined = stuck_links(modes);
  if (joined.empty()) return;
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

}  // namespace host_sim
