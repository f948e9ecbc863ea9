#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "simulator.hpp"

// The equations of motion and their slopes.
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

// Accelerations per force: the inverse of the masses, with stuck links as bodies.
void Simulator::renew_yield() {
  if (!yield_old_) return;
  yield_ = mass_.cwiseInverse().asDiagonal();
  held_.clear();
  for (const Friction& f : friction_)
    if (f.sign == 0) held_.push_back(&f);
  if (!held_.empty()) {
    Mat b = Mat::Zero(nodes_, static_cast<Index>(held_.size()));
    for (size_t i = 0; i < held_.size(); ++i) {
      if (held_[i]->a >= 0) b(held_[i]->a, static_cast<Index>(i)) += 1;
      if (held_[i]->b >= 0) b(held_[i]->b, static_cast<Index>(i)) -= 1;
    }
    const Mat mb = mass_.cwiseInverse().asDiagonal() * b;
    Mat inner = b.transpose() * mb;
    inner.diagonal().array() *= 1 + 1e-12;
    const auto solver = inner.ldlt();
    by_hold_ = solver.solve(mb.transpose());
    inner_inverse_ = solver.solve(Mat::Identity(inner.rows(), inner.cols()));
    yield_ -= mb * by_hold_;
  }
  yield_old_ = false;
}

// How the rates of stuck links would change if their DOFs stayed at rest, per unit of the base's acceleration, turned: what their
// DOFs must take part in.
Vec Simulator::with_base() const {
  Vec c = Vec::Zero(static_cast<Index>(held_.size()));
  for (size_t i = 0; i < held_.size(); ++i)
    c[static_cast<Index>(i)] = held_[i]->b == -2 ? 1 : held_[i]->a == -2 ? -1 : 0;
  return c;
}

void Simulator::accelerations(const Vec& y, const Outside& o, Vec& acc, bool slopes) {
  net_ = o.force;
  const Index columns = states() + parameters_;
  if (slopes) slope_x_.setZero(nodes_, columns);
  renew_yield();
  const auto light = [&](int node) {
    return held_.empty() ? lightness_[node] : 1.0;
  };  // what sticks shares its forces below
  const auto add = [&](int node, Index column, double value) {
    if (node >= 0) slope_x_(node, column) += light(node) * value;
  };
  const auto pull = [&](const Element& e, const LawValue& f) {
    const double force = e.value * f.force;
    if (e.a >= 0) net_[e.a] -= force;
    if (e.b >= 0) net_[e.b] += force;
    if (!slopes) return;
    const double stiff = e.value * f.by_u, drag = e.value * f.by_w;
    for (int side = 0; side < 2; ++side) {
      const int node = side == 0 ? e.a : e.b, other = side == 0 ? e.b : e.a;
      if (node < 0) continue;
      const double ku = light(node) * stiff, cw = light(node) * drag;
      slope_x_(node, node) -= ku, slope_x_(node, nodes_ + node) -= cw;
      if (other >= 0) slope_x_(node, other) += ku, slope_x_(node, nodes_ + other) += cw;
    }
    if (by_base_delay_ >= 0 && (e.a == -2 || e.b == -2))
      add(e.a >= 0 ? e.a : e.b, states() + by_base_delay_, stiff * o.v + drag * o.a);
    if (e.by_value >= 0) add(e.a, states() + e.by_value, -f.force), add(e.b, states() + e.by_value, f.force);
    if (e.by_shape >= 0)
      add(e.a, states() + e.by_shape, -e.value * f.by_log_shape),
          add(e.b, states() + e.by_shape, e.value * f.by_log_shape);
    if (e.by_shape2 >= 0)
      add(e.a, states() + e.by_shape2, -e.value * f.by_shape2), add(e.b, states() + e.by_shape2, e.value * f.by_shape2);
  };
  for (const Element& e : elements_) {
    if (e.kind == Kind::kCoulomb || e.kind == Kind::kMissingCoulomb || e.kind == Kind::kStribeck) continue;
    const double u = relative(y, 0, e.a, e.b, o.x), w = relative(y, nodes_, e.a, e.b, o.v);
    if (e.kind == Kind::kPresliding) {
      const Index z = 2 * nodes_ + e.z;
      double by_z = 1;
      pull(e, bristles(w, y[z], e.shape, e.shape2, by_z));
      if (slopes) add(e.a, z, -e.value * by_z), add(e.b, z, e.value * by_z);
      continue;
    }
    if (e.kind == Kind::kResonance) {
      const double omega = kTwoPi * e.shape;
      pull(e, {omega * omega * u + 2 * e.shape2 * omega * w, omega * omega, 2 * e.shape2 * omega,
               2 * omega * omega * u + 2 * e.shape2 * omega * w});
      continue;
    }
    const double time = law_time(o.t_s, e.shape, record_);
    pull(e, e.linear ? LawValue{e.by_u * u + e.by_w * w, e.by_u, e.by_w} : law(e.kind, u, w, time, e.shape, e.shape2));
  }
  for (const Friction& f : friction_) {
    if (f.sign == 0) continue;
    const double w = relative(y, nodes_, f.a, f.b, o.v);
    for (size_t i : f.levels) {
      const Element& e = elements_[i];
      const double share = e.kind == Kind::kStribeck ? std::exp(-std::abs(w) / e.shape) : 1.0;
      pull(e, {f.sign * share, 0, e.kind == Kind::kStribeck ? -share / e.shape : 0.0,
               e.kind == Kind::kStribeck ? f.sign * share * std::abs(w) / e.shape : 0.0});
    }
  }
  net_ -= o.carried * mass_;
  if (held_.empty())
    acc = net_.cwiseQuotient(mass_);
  else
    acc = yield_ * net_;
  if (!held_.empty() && o.a != 0)  // what sticks to the moving base goes with it
    acc += o.a * (by_hold_.transpose() * with_base());
  if (!slopes) return;
  for (size_t i = 0; i < faults_.size(); ++i)
    if (faults_[i].by_value >= 0) {
      const double r = (o.t_s * substeps_ / record_.step_s - static_cast<double>(at_) / 2);
      add(fine_node_[faults_[i].fine], states() + faults_[i].by_value, drive_at(fine_slope_[i], r));
    }
  for (int node = 0; node < static_cast<int>(nodes_); ++node) {
    if (by_base_delay_ >= 0 && record_.base.ridden) add(node, states() + by_base_delay_, -o.jerk * mass_[node]);
    for (Index p : by_mass_[static_cast<size_t>(node)]) add(node, states() + p, -(acc[node] + o.carried));
  }
  if (held_.empty()) return;
  slope_x_ = yield_ * slope_x_;
  if (by_base_delay_ >= 0 && !record_.base.ridden)
    slope_x_.col(states() + by_base_delay_) += o.jerk * (by_hold_.transpose() * with_base());
}

}  // namespace diagnosis::runs
