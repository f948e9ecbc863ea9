// Force per unit coefficient and its slopes, one function a law. Included by law_table.hpp alone.
#pragma once
#include <algorithm>
#include <cmath>

#include "host_sim/vocabulary/law.hpp"

namespace vocabulary {
namespace laws {

inline Force acceleration(const Point& at, const Shape&) {
  Force f;
  f.value = at.a, f.slope.a = 1.0;
  return f;
}
inline Force elongation(const Point& at, const Shape&) {
  Force f;
  f.value = at.u, f.slope.u = 1.0;
  return f;
}
inline Force rate(const Point& at, const Shape&) {
  Force f;
  f.value = at.w, f.slope.w = 1.0;
  return f;
}
inline Force dry_friction(const Point& at, const Shape&) {
  Force f;
  f.value = at.sign;
  return f;
}
inline Force pendulum(const Point& at, const Shape&) {
  Force f;
  f.value = std::sin(at.u), f.slope.u = std::cos(at.u);
  return f;
}
inline Force cubic_spring(const Point& at, const Shape&) {
  Force f;
  f.value = at.u * at.u * at.u, f.slope.u = 3.0 * at.u * at.u;
  return f;
}
inline Force quadratic_spring(const Point& at, const Shape&) {
  Force f;
  f.value = at.u * at.u, f.slope.u = 2.0 * at.u;
  return f;
}
inline Force gap_lost(const Point& at, const Shape& shape) {  // -clamp(u, -gap, gap)
  Force f;
  if (at.side == 0)
    f.value = -at.u, f.slope.u = -1.0;
  else
    f.value = -at.side * shape.p[0], f.slope.shape[0] = -at.side;
  return f;
}
inline Force within_gap(const Point& at, const Shape& shape) {  // clamp(u, -gap, gap)
  Force f = gap_lost(at, shape);
  f.value = -f.value, f.slope.u = -f.slope.u, f.slope.shape[0] = -f.slope.shape[0];
  return f;
}
inline Force beyond_gap(const Point& at, const Shape& shape) {
  Force f;
  if (at.side != 0) f.value = at.u - at.side * shape.p[0], f.slope.u = 1.0, f.slope.shape[0] = -at.side;
  return f;
}
inline Force quadratic_damper(const Point& at, const Shape&) {
  Force f;
  f.value = at.w * at.w * at.sign, f.slope.w = 2.0 * at.w * at.sign;
  return f;
}
inline Force cubic_damper(const Point& at, const Shape&) {
  Force f;
  f.value = at.w * at.w * at.w, f.slope.w = 3.0 * at.w * at.w;
  return f;
}
// Fs exp(-|w| / vs) sgn(w): goes on smoothly past w = 0 while the sign is held.
inline Force stribeck(const Point& at, const Shape& shape) {
  Force f;
  const double speed = at.sign * at.w, decay = std::exp(-speed / shape.p[0]);
  f.value = at.sign * decay;
  f.slope.w = -at.sign * at.sign * decay / shape.p[0];
  f.slope.shape[0] = f.value * speed / (shape.p[0] * shape.p[0]);
  return f;
}
inline Force constant(const Point&, const Shape&) {
  Force f;
  f.value = 1.0;
  return f;
}
// A hold changes what drives the rig between samples, a high-pass remembers what its channel has read: no force of the moment.
inline Force none(const Point&, const Shape&) { return {}; }
inline Force one_way_damper(const Point& at, const Shape&) {
  Force f;
  f.value = at.w * at.sign, f.slope.w = at.sign;
  return f;
}
inline Force displaced_damper(const Point& at, const Shape&) {
  Force f;
  f.value = at.u * at.u * at.w, f.slope.u = 2.0 * at.u * at.w, f.slope.w = at.u * at.u;
  return f;
}
inline Force drifting_damper(const Point& at, const Shape& shape) {
  Force f;
  const double tau = shape.p[0], t = std::max(at.t_s, 0.0);
  f.slope.w = drifted_s(at.t_s, tau);
  f.value = at.w * f.slope.w;
  if (tau > 0.0) f.slope.shape[0] = at.w * (-std::expm1(-t / tau) - t / tau * std::exp(-t / tau));
  return f;
}
inline Force cogging(const Point& at, const Shape& shape) {
  Force f;
  constexpr double kTwoPi = 6.283185307179586476925;
  const double angle = kTwoPi * at.u / shape.p[0] + shape.p[1];
  f.value = std::sin(angle);
  f.slope.shape[1] = std::cos(angle);
  f.slope.u = kTwoPi / shape.p[0] * f.slope.shape[1];
  f.slope.shape[0] = -f.slope.u * at.u / shape.p[0];
  return f;
}
// Gain, offset and delay of a reading: c, 1 and, to its first order, -dc/dt.
inline Force late(const Point& at, const Shape&) {
  Force f;
  f.value = -at.w, f.slope.w = -1.0;
  return f;
}
inline Force hum(const Point& at, const Shape& shape) {
  Force f;
  constexpr double kTwoPi = 6.283185307179586476925;
  const double angle = kTwoPi * shape.p[0] * at.t_s + shape.p[1];
  f.value = std::cos(angle);
  f.slope.shape[0] = -kTwoPi * at.t_s * std::sin(angle);
  f.slope.shape[1] = -std::sin(angle);
  return f;
}

}  // namespace laws
}  // namespace vocabulary
