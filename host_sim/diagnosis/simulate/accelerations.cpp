// The equations of motion and their slopes.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "simulator.hpp"

namespace diagnosis::runs {

double Simulator::relative(const Vec& y, Index offset, int a, int b, double base) const {
  const auto end = [&](int i) { return i >= 0 ? y[offset + i] : i == -2 ? base : 0.0; };
  return end(a) - end(b);
}

double Simulator::level(const Friction& f, double w) const {
  double sum = 0;
  for (size_t i : f.levels) {
    const Element& e = elements_[i];
    sum += e.value * (e.kind == Kind::kStribeck ? std::exp(-std::abs(w) / e.shape) : 1.0);
  }
  return sum;
}

// Of a node by a column of the state and the parameters. What sticks shares its forces later, by now_->yield.
inline void Simulator::add_slope(int node, Index column, double value) {
  if (node >= 0) slope_x_(node, column) += (now_->held.empty() ? lightness_[node] : 1.0) * value;
}

inline void Simulator::add_slopes(const Element& e, Index column, double value) {
  add_slope(e.a, column, -value), add_slope(e.b, column, value);
}

inline void Simulator::pull(const Element& e, const LawValue& f, const Outside& o, bool slopes) {
  const double force = e.value * f.force;
  if (e.a >= 0) net_[e.a] -= force;
  if (e.b >= 0) net_[e.b] += force;
  if (!slopes) return;
  const double stiff = e.value * f.by_u, drag = e.value * f.by_w;
  for (int side = 0; side < 2; ++side) {
    const int node = side == 0 ? e.a : e.b, other = side == 0 ? e.b : e.a;
    if (node < 0) continue;
    const double light = now_->held.empty() ? lightness_[node] : 1.0, ku = light * stiff, cw = light * drag;
    slope_x_(node, node) -= ku, slope_x_(node, nodes_ + node) -= cw;
    if (other >= 0) slope_x_(node, other) += ku, slope_x_(node, nodes_ + other) += cw;
  }
  if (by_base_delay_ >= 0 && (e.a == -2 || e.b == -2))
    add_slope(e.a >= 0 ? e.a : e.b, states() + by_base_delay_, stiff * o.v + drag * o.a);
  if (e.by_value >= 0) add_slopes(e, states() + e.by_value, f.force);
  if (e.by_shape >= 0) add_slopes(e, states() + e.by_shape, e.value * f.by_log_shape);
  if (e.by_shape2 >= 0) add_slopes(e, states() + e.by_shape2, e.value * f.by_shape2);
}

// Of everything but dry friction.
inline void Simulator::pull_elements(const Vec& y, const Outside& o, bool slopes) {
  for (const Element& e : elements_) {
    if (e.kind == Kind::kCoulomb || e.kind == Kind::kMissingCoulomb || e.kind == Kind::kStribeck) continue;
    const double u = relative(y, 0, e.a, e.b, o.x), w = relative(y, nodes_, e.a, e.b, o.v);
    if (e.kind == Kind::kPresliding) {
      const Index z = 2 * nodes_ + e.z;
      double by_z = 1;
      pull(e, bristles(w, y[z], e.shape, e.shape2, by_z), o, slopes);
      if (slopes) add_slopes(e, z, e.value * by_z);
      continue;
    }
    if (e.kind == Kind::kResonance) {
      const double omega = kTwoPi * e.shape;
      pull(e,
           {omega * omega * u + 2 * e.shape2 * omega * w, omega * omega, 2 * e.shape2 * omega,
            2 * omega * omega * u + 2 * e.shape2 * omega * w, 2 * e.shape2 * omega * w},
           o, slopes);
      continue;
    }
    const double time = law_time(o.t_s, e.shape, record_);
    pull(e, e.linear ? LawValue{e.by_u * u + e.by_w * w, e.by_u, e.by_w} : law(e.kind, u, w, time, e.shape, e.shape2),
         o, slopes);
  }
}

// Where it slides.
inline void Simulator::pull_friction(const Vec& y, const Outside& o, bool slopes) {
  for (const Friction& f : friction_) {
    if (f.sign == 0) continue;
    const double w = relative(y, nodes_, f.a, f.b, o.v);
    for (size_t i : f.levels) {
      const Element& e = elements_[i];
      const double share = e.kind == Kind::kStribeck ? std::exp(-std::abs(w) / e.shape) : 1.0;
      pull(e,
           {f.sign * share, 0, e.kind == Kind::kStribeck ? -share / e.shape : 0.0,
            e.kind == Kind::kStribeck ? f.sign * share * std::abs(w) / e.shape : 0.0},
           o, slopes);
    }
  }
}

// By what is no force of an element: faults of the drives, the base's delay, masses; and what sticks shares its slopes.
inline void Simulator::finish_slopes(const Outside& o, const Vec& acc) {
  for (size_t i = 0; i < faults_.size(); ++i)
    if (faults_[i].by_value >= 0) {
      const double r = (o.t_s * substeps_ / record_.step_s - static_cast<double>(at_) / 2);
      add_slope(fine_node_[faults_[i].fine], states() + faults_[i].by_value, drive_at(fine_slope_[i], r));
    }
  for (int node = 0; node < static_cast<int>(nodes_); ++node) {
    if (by_base_delay_ >= 0 && record_.base.ridden) add_slope(node, states() + by_base_delay_, -o.jerk * mass_[node]);
    for (Index p : by_mass_[static_cast<size_t>(node)]) add_slope(node, states() + p, -(acc[node] + o.carried));
  }
  if (now_->held.empty()) return;
  alone_.swap(slope_x_);  // as if nothing stuck
  slope_x_.noalias() = now_->yield.lazyProduct(alone_);
  if (by_base_delay_ >= 0 && !record_.base.ridden)
    slope_x_.col(states() + by_base_delay_) += o.jerk * (now_->by_hold.transpose() * with_base());
}

void Simulator::accelerations(const Vec& y, const Outside& o, Vec& acc, bool slopes) {
  net_ = o.force;
  if (slopes) slope_x_.setZero(nodes_, states() + parameters_);
  renew_yield();
  pull_elements(y, o, slopes);
  pull_friction(y, o, slopes);
  if (o.carried != 0) net_ -= o.carried * mass_;
  if (now_->held.empty()) {  // one by one, as they were written: pairs would have to wait for it
    acc.resize(nodes_);
    for (Index node = 0; node < nodes_; ++node) acc[node] = net_[node] / mass_[node];
  } else {
    acc.noalias() = now_->yield.lazyProduct(net_);
    if (o.a != 0)
      acc += o.a * (now_->by_hold.transpose() * with_base());  // what sticks to the moving base goes with it
  }
  if (slopes) finish_slopes(o, acc);
}

}  // namespace diagnosis::runs
