// The motion that an accelerometer and a slower sensor of one place share.
#include "fused.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

namespace diagnosis::runs {
namespace {

using State = Eigen::Vector3d;  // displacement, velocity, the accelerometer's zero
using Spread = Eigen::Matrix3d;

double spread_of(const Vec& y) { return std::max(noise_level(y), kFinest * rms_about_mean(y)) + 1e-300; }

// What the acceleration adds to velocity and displacement from one sample to the next: integrals of the cubic through four.
struct Push {
  double v = 0, x = 0;
};
Push push_of(const Vec& a, Index i, double step_s) {
  const Index n = a.size();
  const double before = a[std::max<Index>(0, i - 1)], here = a[i], next = a[i + 1], after = a[std::min(n - 1, i + 2)];
  return {step_s * (-before + 13 * here + 13 * next - after) / 24,
          step_s * step_s * (-8 * before + 129 * here + 66 * next - 7 * after) / 360};
}

struct Estimate {
  State mean = State::Zero();
  Spread spread = Spread::Zero();
};

// One reading of a state's component.
void learn(Estimate& e, int component, double reading, double variance) {
  const State gain = e.spread.col(component) / (e.spread(component, component) + variance);
  e.mean += gain * (reading - e.mean[component]);
  e.spread -= (gain * e.spread.row(component)).eval();
}

}  // namespace

Guess fused_by_acceleration(const Vec* x, const Vec* v, const Vec& a, double step_s) {
  const Index n = a.size();
  const double sa = spread_of(a), sx = x ? spread_of(*x) : 0, sv = v ? spread_of(*v) : 0;
  Spread forward = Spread::Identity();
  forward(0, 1) = step_s, forward(0, 2) = -0.5 * step_s * step_s, forward(1, 2) = -step_s;
  const Eigen::Vector3d reach(0.5 * step_s * step_s, step_s, 0);
  const Spread added = sa * sa * reach * reach.transpose();
  std::vector<Estimate> before(static_cast<size_t>(n)), after(static_cast<size_t>(n));
  Estimate e;
  const double v_rms = v ? std::sqrt(v->squaredNorm() / static_cast<double>(n)) : 0;
  const double x_rms = x ? std::sqrt(x->squaredNorm() / static_cast<double>(n)) : 0,
               a_rms = std::sqrt(a.squaredNorm() / static_cast<double>(n));
  // at the start nothing is known but the sizes that the motion has
  e.spread(0, 0) = 1e2 * x_rms * x_rms, e.spread(1, 1) = 1e2 * (v ? v_rms * v_rms : a_rms * x_rms),
              e.spread(2, 2) = a_rms * a_rms;
  for (Index i = 0; i < n; ++i) {
    before[static_cast<size_t>(i)] = e;
    if (x) learn(e, 0, (*x)[i], sx * sx);
    if (v) learn(e, 1, (*v)[i], sv * sv);
    after[static_cast<size_t>(i)] = e;
    if (i + 1 == n) break;
    const Push push = push_of(a, i, step_s);
    e.mean = forward * e.mean + State(push.x, push.v, 0);
    e.spread = (forward * e.spread * forward.transpose() + added).eval();
  }
  Guess g;
  g.given = true, g.x.resize(n), g.v.resize(n), g.a.resize(n);
  State later = after.back().mean;  // Rauch, Tung and Striebel, from the end
  for (Index i = n - 1;; --i) {
    const Estimate& now = after[static_cast<size_t>(i)];
    if (i + 1 < n) {
      const Estimate& next = before[static_cast<size_t>(i + 1)];
      const State size = next.spread.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
      const Spread scaled = size.asDiagonal() * next.spread * size.asDiagonal();
      const State step = size.asDiagonal() * scaled.ldlt().solve(size.asDiagonal() * (later - next.mean));
      later = now.mean + now.spread * forward.transpose() * step;
    }
    g.x[i] = later[0], g.v[i] = later[1], g.a[i] = a[i] - later[2];
    if (i == 0) break;
  }
  return g;
}

}  // namespace diagnosis::runs
