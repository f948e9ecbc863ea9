#include <algorithm>
#include <cmath>

#include "firmware/fixed_point/wider_vectors.hpp"
#include "simulator.hpp"

// One step of Runge and Kutta, and what bends within it.
namespace diagnosis::runs {

FIRMWARE_WIDER_VECTORS void add_product(const Mat& from, const Sensitivity& of, Sensitivity& to) {
  constexpr int kTogether = 4;  // rows that are added in one go: the sum is loaded and stored once
  const Index columns = of.cols();
  for (Index r = 0; r < from.rows(); ++r) {
    double* const sum = &to(r, 0);
    double value[kTogether];
    const double* row[kTogether];
    int found = 0;
    for (Index c = 0; c < of.rows(); ++c) {
      if (from(r, c) == 0) continue;
      value[found] = from(r, c), row[found] = &of(c, 0);
      if (++found < kTogether) continue;
      for (Index k = 0; k < columns; ++k)
        sum[k] =
            (((sum[k] + value[0] * row[0][k]) + value[1] * row[1][k]) + value[2] * row[2][k]) + value[3] * row[3][k];
      found = 0;
    }
    for (int i = 0; i < found; ++i)
      for (Index k = 0; k < columns; ++k) sum[k] += value[i] * row[i][k];
  }
}

namespace {

// A point on the way from a start.
FIRMWARE_WIDER_VECTORS void move(const double* start, const double* rate, double time, Index count,
                                 double* __restrict to) {
  for (Index i = 0; i < count; ++i) to[i] = start[i] + time * rate[i];
}

// The end of a step of order 4.
FIRMWARE_WIDER_VECTORS void combine(const double* const (&rate)[4], double sixth, Index count, double* to) {
  for (Index i = 0; i < count; ++i) to[i] += sixth * (((rate[0][i] + 2 * rate[1][i]) + 2 * rate[2][i]) + rate[3][i]);
}

}  // namespace

void answer(const Mat& slopes, const Sensitivity& of_state, Sensitivity& rows) {
  const Index states = of_state.rows(), columns = of_state.cols();
  rows.setZero(slopes.rows(), columns);
  rows.rightCols(columns - states) = slopes.rightCols(columns - states);
  add_product(slopes, of_state, rows);
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

// Displacements and velocities of `from` after a time at the rates of a stage.
void Simulator::carry(int stage, const Sensitivity& from, double step_s, Sensitivity& to) const {
  const Index half = nodes_ * from.cols();
  move(from.data(), stage_[stage].data() + half, step_s, half, to.data());
  move(from.data() + half, ka_[stage].data(), step_s, half, to.data() + half);
}

// One Runge-Kutta step over a part of the present substep, modes held.
void Simulator::step(double from, double length, Vec& y, Sensitivity* s) {
  if (from == 0 && length == 1)
    if (const Affine* const affine = affine_now()) {
      begun_.is = false;
      return affine_step(*affine, y, s);
    }
  const double h = length * record_.step_s / substeps_;
  const Outside o0 = outside(from), o1 = outside(from + 0.5 * length), o2 = outside(from + length);
  static thread_local Vec y0, yn;
  y0 = y, yn = y;
  const Index n = nodes_;
  if (s) stage_[0] = *s;
  static thread_local Vec kx[4];
  const bool begins = begun_.is && from == 0 && begun_.at == at_ && (begun_.slopes || !s) && begun_.y == y;
  begun_.is = false;
  const auto slope = [&](int i, const Outside& o) {
    if (i > 0 || !begins) accelerations(yn, o, acc_[i], s != nullptr);
    kx[i] = yn.segment(n, n);
    if (s && (i > 0 || !begins || begun_.rows != s)) answer(slope_x_, stage_[i], ka_[i]);
  };
  const auto move_on = [&](int i, double part, const Outside& o) {
    yn.head(n) = y0.head(n) + part * h * kx[i];
    yn.segment(n, n) = y0.segment(n, n) + part * h * acc_[i];
    if (s) {
      Sensitivity& next = stage_[i + 1];
      next.resize(s->rows(), s->cols());
      carry(i, stage_[0], part * h, next);
    }
    if (hysteresis_) bend(y0, yn, o0, o, s ? &stage_[0] : nullptr, s ? &stage_[i + 1] : nullptr);
  };
  slope(0, o0), move_on(0, 0.5, o1), slope(1, o1), move_on(1, 0.5, o1), slope(2, o1), move_on(2, 1, o2), slope(3, o2);
  y.head(n) = y0.head(n) + h / 6 * (kx[0] + 2 * kx[1] + 2 * kx[2] + kx[3]);
  y.segment(n, n) = y0.segment(n, n) + h / 6 * (acc_[0] + 2 * acc_[1] + 2 * acc_[2] + acc_[3]);
  if (s) {
    const Index half = n * s->cols();
    combine({stage_[0].data() + half, stage_[1].data() + half, stage_[2].data() + half, stage_[3].data() + half}, h / 6,
            half, s->data());
    combine({ka_[0].data(), ka_[1].data(), ka_[2].data(), ka_[3].data()}, h / 6, half, s->data() + half);
  }
  if (hysteresis_) bend(y0, y, o0, o2, s ? &stage_[0] : nullptr, s);
}

}  // namespace diagnosis::runs
