#include <algorithm>
#include <cmath>

#include "firmware/fixed_point/wider_vectors.hpp"
#include "simulator.hpp"

// One step of Runge and Kutta, and what bends within it.
namespace diagnosis::runs {

FIRMWARE_WIDER_VECTORS void add_product(const Mat& from, const Sensitivity& of, Sensitivity& to) {
  const Index columns = of.cols();
  for (Index r = 0; r < from.rows(); ++r) {
    double* const sum = &to(r, 0);
    for (Index c = 0; c < of.rows(); ++c) {
      const double value = from(r, c);
      if (value == 0) continue;
      const double* const row = &of(c, 0);
      for (Index k = 0; k < columns; ++k) sum[k] += value * row[k];
    }
  }
}

// Bristles at a later instant of the same step: they relax towards the direction of the way gone since its start.
void Simulator::bend(const Vec& start, Vec& y, const Outside& o0, const Outside& o1, const Sensitivity* s0,
                     Sensitivity* s) const {
  for (const Element& e : elements_) {
    if (e.kind != Kind::kPresliding) continue;
    const Index z = 2 * nodes_ + e.z;
    const double way = relative(y, 0, e.a, e.b, o1.x) - relative(start, 0, e.a, e.b, o0.x);
    const double sign = way < 0 ? -1 : 1, fade = std::exp(-std::abs(way) / e.shape);
    y[z] = sign + (start[z] - sign) * fade;
    if (!s) continue;
    const double by_u = (1 - sign * y[z]) / e.shape;
    s->row(z) = fade * s0->row(z);
    for (int side = 0; side < 2; ++side) {
      const int node = side == 0 ? e.a : e.b;
      if (node >= 0) s->row(z) += (side == 0 ? by_u : -by_u) * (s->row(node) - s0->row(node));
    }
    if (e.by_shape >= 0) (*s)(z, states() + e.by_shape) += (start[z] - sign) * fade * std::abs(way) / e.shape;
  }
}

// One Runge-Kutta step over a part of the present substep, modes held.
void Simulator::step(double from, double length, Vec& y, Sensitivity* s) {
  const double h = length * record_.step_s / substeps_;
  const Outside o0 = outside(from), o1 = outside(from + 0.5 * length), o2 = outside(from + length);
  static thread_local Vec y0, yn;
  y0 = y, yn = y;
  static thread_local Sensitivity s0, sn;
  const Index n = nodes_;
  if (s) s0 = *s, sn = *s;
  static thread_local Vec kx[4];
  const bool begins = begun_.is && from == 0 && begun_.at == at_ && (begun_.slopes || !s) && begun_.y == y;
  begun_.is = false;
  const auto slope = [&](int i, const Outside& o) {
    if (i > 0 || !begins) accelerations(yn, o, acc_[i], s != nullptr);
    kx[i] = yn.segment(n, n);
    if (!s) return;
    kv_[i] = sn.middleRows(n, n);
    ka_[i].setZero(n, sn.cols());
    ka_[i].rightCols(parameters_) = slope_x_.rightCols(parameters_);
    add_product(slope_x_, sn, ka_[i]);
  };
  const auto move = [&](int i, double part, const Outside& o) {
    yn.head(n) = y0.head(n) + part * h * kx[i];
    yn.segment(n, n) = y0.segment(n, n) + part * h * acc_[i];
    if (s) {
      sn.topRows(n) = s0.topRows(n) + part * h * kv_[i];
      sn.middleRows(n, n) = s0.middleRows(n, n) + part * h * ka_[i];
    }
    if (hysteresis_) bend(y0, yn, o0, o, s ? &s0 : nullptr, s ? &sn : nullptr);
  };
  slope(0, o0), move(0, 0.5, o1), slope(1, o1), move(1, 0.5, o1), slope(2, o1), move(2, 1, o2), slope(3, o2);
  y.head(n) = y0.head(n) + h / 6 * (kx[0] + 2 * kx[1] + 2 * kx[2] + kx[3]);
  y.segment(n, n) = y0.segment(n, n) + h / 6 * (acc_[0] + 2 * acc_[1] + 2 * acc_[2] + acc_[3]);
  if (s) {
    s->topRows(n) = s0.topRows(n) + h / 6 * (kv_[0] + 2 * kv_[1] + 2 * kv_[2] + kv_[3]);
    s->middleRows(n, n) = s0.middleRows(n, n) + h / 6 * (ka_[0] + 2 * ka_[1] + 2 * ka_[2] + ka_[3]);
  }
  if (hysteresis_) bend(y0, y, o0, o2, s ? &s0 : nullptr, s);
}

}  // namespace diagnosis::runs
