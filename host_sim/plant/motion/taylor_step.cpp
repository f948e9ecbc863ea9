#include "host_sim/plant/motion/taylor_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// A rig has few links and masses: vectors of them take longer to begin.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-tree-loop-vectorize")
#endif

namespace host_sim {
namespace {

constexpr double kMostTurn_rad = 2.0;  // terms up to 2^2 / 2!: one bit is lost
constexpr double kRounding = 5e-17;
constexpr int kFirstJudged = 8;  // what begins at rest, under a force that is a fifth power at most, shows by then

}  // namespace

TaylorStep::TaylorStep(const Equations& equations, const Excitation& excitation)
    : equations_(equations),
      masses_(equations.masses()),
      nodes_(masses_ + 2),
      x_(static_cast<size_t>(kMost + 1) * nodes_, 0.0),
      drive_(x_.size(), 0.0),
      body_sum_(nodes_),
      body_mass_(nodes_) {
  std::vector<double> stiffness(nodes_, 0.0), viscous(nodes_, 0.0);
  for (const PlantLink& from : equations.links()) {
    Link link{from.a, from.b};
    for (const PlantTerm& term : from.terms)
      (term.kind == vocabulary::EffectKind::kStiffness ? link.stiffness
       : term.kind == vocabulary::EffectKind::kViscous ? link.viscous
                                                       : link.friction) += term.coefficient;
    for (const size_t end : {link.a, link.b}) {
      stiffness[end] += std::fabs(link.stiffness);
      viscous[end] += std::fabs(link.viscous);
    }
    links_.push_back(link);
  }
  for (size_t i = 0; i < masses_; ++i) {
    for (size_t l = 0; l < links_.size(); ++l) {
      const Link& link = links_[l];
      const auto add_end = [&](double sign) {
        ends_.push_back({link.a, link.b, l, link.stiffness, link.viscous, link.friction, sign});
      };
      if (link.a == i) add_end(1.0);
      if (link.b == i) add_end(-1.0);
    }
    ends_of_.push_back(ends_.size());
    two_ends_ = two_ends_ && ends_.size() == 2 * ends_of_.size();
  }
  double fastest = 0.0;  // Gershgorin: no eigenvalue of M^-1 K is above 2 sum of k / m
  for (size_t i = 0; i < masses_; ++i) {
    const double mass = equations.mass(i);
    mass_.push_back(mass);
    fastest = std::max({fastest, std::sqrt(2.0 * stiffness[i] / mass), 2.0 * viscous[i] / mass});
  }
  longest_step_s_ = fastest > 0.0 ? kMostTurn_rad / fastest : std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < excitation.force_N.size() && i < masses_; ++i)
    if (excitation.force_N[i]) drives_.push_back({i, excitation.force_N[i].get(), {}});
  base_ = {masses_ + 1, excitation.base_m.get(), {}};
}

double TaylorStep::smooth_until(double t_s) const {
  double until = std::numeric_limits<double>::infinity();
  for (const Drive& drive : drives_) until = std::min(until, drive.signal->smooth_until(t_s));
  return base_.signal == nullptr ? until : std::min(until, base_.signal->smooth_until(t_s));
}

void TaylorStep::set_drives(double t_s, double step_s) {
  std::fill(drive_row(0), drive_row(driven_), 0.0);
  driven_ = 0;
  for (Drive& drive : drives_) {
    const int count = drive.signal->expand(t_s, step_s, kMost, drive.c);
    for (int k = 0; k < count; ++k) drive_row(k)[drive.node] = drive.c[k];
    driven_ = std::max(driven_, count);
  }
  if (base_.signal == nullptr) return;
  const int count = base_.signal->expand(t_s, step_s, kMost + 1, base_.c);
  for (int k = 0; k <= kMost; ++k) row(k)[masses_ + 1] = k < count ? base_.c[k] : 0.0;
}

// take(i, net force on mass i) of the k-th coefficients. A link's force is made anew at each of its ends: what waits for the step
// before never leaves the registers.
template <typename Take>
inline void TaylorStep::each_net_force(int k, const Modes& modes, Take take) {
  const double *x = row(k), *next = row(k + 1), *drive = drive_row(k);
  const double per_s = static_cast<double>(k + 1) / step_s_;
  const auto at = [&](const End& end) {
    double force = end.stiffness * (x[end.a] - x[end.b]) + end.viscous * per_s * (next[end.a] - next[end.b]);
    if (k == 0) force += end.friction * static_cast<double>(modes.rate_sign[end.link]);
    return end.sign * force;
  };
  const End* end = ends_.data();
  if (two_ends_) {
    for (size_t i = 0; i < masses_; ++i, end += 2) take(i, drive[i] - at(end[0]) - at(end[1]));
    return;
  }
  for (size_t i = 0; i < masses_; ++i) {
    double net = drive[i];
    for (const End* const last = ends_.data() + ends_of_[i]; end != last; ++end) net -= at(*end);
    take(i, net);
  }
}

// next = factor M^-1 net, net of the k-th coefficients; masses that are tied together move alike, and with the ground or the base
// where these are among them. Returns the largest.
inline double TaylorStep::accelerate(int k, const Modes& modes, double factor, double* next) {
  double largest = 0.0;
  if (body_.empty()) {
    each_net_force(k, modes, [&](size_t i, double net) {
      const double coefficient = next[i] = factor * net / mass_[i];
      largest = std::max(largest, std::fabs(coefficient));
    });
    return largest;
  }
  std::fill(body_sum_.begin(), body_sum_.end(), 0.0);
  each_net_force(k, modes, [&](size_t i, double net) { body_sum_[body_[i]] += net; });
  for (size_t i = 0; i < masses_; ++i) {
    const bool on_ground = body_[i] == body_[masses_], on_base = body_[i] == body_[masses_ + 1];
    next[i] = on_ground ? 0.0 : on_base ? next[masses_ + 1] : factor * body_sum_[body_[i]] / body_mass_[body_[i]];
    largest = std::max(largest, std::fabs(next[i]));
  }
  return largest;
}

bool TaylorStep::expand(double t_s, double step_s, const double* y, const Modes& modes, const MotionScale& scale) {
  step_s_ = step_s;
  set_drives(t_s, step_s);
  body_ = equations_.stuck_bodies(modes);
  if (!body_.empty()) {
    std::fill(body_mass_.begin(), body_mass_.end(), 0.0);
    for (size_t i = 0; i < masses_; ++i) body_mass_[body_[i]] += mass_[i];
  }
  for (size_t i = 0; i < masses_; ++i) {
    row(0)[i] = y[i];
    row(1)[i] = y[masses_ + i] * step_s;
  }
  const double rounding = kRounding * std::min(scale.displacement, scale.velocity * step_s);
  int small = 0;
  for (int k = 0; k + 2 <= kMost; ++k) {
    const double largest = accelerate(k, modes, step_s * step_s / static_cast<double>((k + 1) * (k + 2)), row(k + 2));
    small = largest * static_cast<double>(k + 2) <= rounding ? small + 1 : 0;
    order_ = k + 2;
    if (small >= 2 && order_ >= kFirstJudged) return true;
  }
  return false;
}

void TaylorStep::state(double theta, double* y) const {
  for (size_t i = 0; i < masses_; ++i) {
    const double* x = row(order_) + i;
    double value = 0.0, rate = 0.0, k = order_;
    if (theta == 1.0) {  // nearly always: the step's end
      for (int left = order_; left > 0; --left, k -= 1.0, x -= nodes_) value += *x, rate += k * *x;
    } else {
      for (int left = order_; left > 0; --left, k -= 1.0, x -= nodes_) {
        value = value * theta + *x;
        rate = rate * theta + k * *x;
      }
    }
    y[i] = value * theta + *x;
    y[masses_ + i] = rate / step_s_;
  }
}

double TaylorStep::nearest_to_rest(size_t link, int sign) const {
  const Link& at = links_[link];
  const double begin = 2.0 * sign * (row(2)[at.a] - row(2)[at.b]);  // slopes of the rate
  if (begin >= 0.0) return 1.0;
  double end = 0.0;
  for (int k = 2; k <= order_; ++k) end += k * (k - 1) * sign * (row(k)[at.a] - row(k)[at.b]);
  return end > 0.0 ? begin / (begin - end) : 1.0;
}

}  // namespace host_sim
