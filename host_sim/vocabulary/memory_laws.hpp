// Laws that remember: bristles (Dahl, LuGre) and a hidden mass on a spring. Included by law_table.hpp alone.
#pragma once
#include <cmath>

#include "host_sim/vocabulary/law.hpp"

namespace vocabulary {
namespace laws {

// dz/dt = (w - |w| z) / length: P. Dahl, "A solid friction model" (1968), with exponent 1, per unit level.
inline MemoryRate bristle_rate(const Point& at, const Shape& shape) {
  MemoryRate r;
  const double length = shape.p[0], way = 1.0 - at.sign * at.z[0];
  r.value[0] = at.w * way / length;
  r.slope[0].w = way / length;
  r.slope[0].z[0] = -at.w * at.sign / length;
  r.slope[0].shape[0] = -r.value[0] / length;
  return r;
}
// z + tau dz/dt: C. Canudas de Wit et al., "A new model for control of systems with friction", IEEE TAC 40 (1995).
inline Force bristles(const Point& at, const Shape& shape) {
  Force f;
  const double tau = shape.p[1];
  f.value = at.z[0], f.slope.z[0] = 1.0;
  const MemoryRate r = bristle_rate(at, shape);
  f.value += tau * r.value[0];
  f.slope.w = tau * r.slope[0].w;
  f.slope.z[0] += tau * r.slope[0].z[0];
  f.slope.shape[0] = tau * r.slope[0].shape[0];
  f.slope.shape[1] = r.value[0];
  return f;
}
inline void bristles_at_start(const Point& at, const Shape&, double* z) { z[0] = (at.w > 0.0) - (at.w < 0.0); }
inline void bend_bristles(const Point& from, const Point& to, double, const Shape& shape, double* z) {
  const double way = to.u - from.u;
  if (way == 0.0) return;
  const double end = way > 0.0 ? 1.0 : -1.0;
  z[0] = end + (z[0] - end) * std::exp(-std::abs(way) / shape.p[0]);
}

// z = place and velocity of the hidden mass; its acceleration is the force on the DOF per unit mass.
inline Force hidden_mass(const Point& at, const Shape& shape) {
  constexpr double kTwoPi = 6.283185307179586476925;
  Force f;
  const double o = kTwoPi * shape.p[0], damping = 2.0 * shape.p[1] * o;
  const double x = at.u - at.z[0], v = at.w - at.z[1];
  f.value = o * o * x + damping * v;
  f.slope.u = o * o, f.slope.w = damping;
  f.slope.z[0] = -o * o, f.slope.z[1] = -damping;
  f.slope.shape[0] = kTwoPi * (2.0 * o * x + 2.0 * shape.p[1] * v);
  f.slope.shape[1] = 2.0 * o * v;
  return f;
}
inline MemoryRate hidden_mass_rate(const Point& at, const Shape& shape) {
  MemoryRate r;
  const Force f = hidden_mass(at, shape);
  r.value[0] = at.z[1], r.slope[0].z[1] = 1.0;
  r.value[1] = f.value, r.slope[1] = f.slope;
  return r;
}
inline void hidden_mass_at_start(const Point& at, const Shape&, double* z) { z[0] = at.u, z[1] = at.w; }
// The oscillator's own decay and turn over a step, and a polynomial that solves its equation under the DOF's motion, taken
// as the cubic through place and velocity at both ends: exact for that motion at any step.
inline void move_hidden_mass(const Point& from, const Point& to, double h, const Shape& shape, double* z) {
  constexpr double kTwoPi = 6.283185307179586476925;
  const double o = kTwoPi * shape.p[0], sigma = shape.p[1] * o, c = 2.0 * sigma, k = o * o;
  const double slope = (to.u - from.u) / h;
  const double x2 = (3.0 * slope - 2.0 * from.w - to.w) / h, x3 = (from.w + to.w - 2.0 * slope) / (h * h);
  const double f0 = k * from.u + c * from.w, f1 = k * from.w + 2.0 * c * x2, f2 = k * x2 + 3.0 * c * x3, f3 = k * x3;
  const double p3 = f3 / k, p2 = (f2 - 3.0 * c * p3) / k, p1 = (f1 - 2.0 * c * p2 - 6.0 * p3) / k,
               p0 = (f0 - c * p1 - 2.0 * p2) / k;
  const double square = k - sigma * sigma, turn = std::sqrt(std::abs(square)) * h;
  const double cosine = square > 0.0 ? std::cos(turn) : std::cosh(turn);
  const double sine = turn == 0.0 ? h : (square > 0.0 ? std::sin(turn) : std::sinh(turn)) * h / turn;
  const double decay = std::exp(-sigma * h), x = z[0] - p0, v = z[1] - p1;
  z[0] = p0 + h * (p1 + h * (p2 + h * p3)) + decay * (x * (cosine + sigma * sine) + v * sine);
  z[1] = p1 + h * (2.0 * p2 + 3.0 * h * p3) + decay * (v * (cosine - sigma * sine) - x * k * sine);
}

}  // namespace laws
}  // namespace vocabulary
