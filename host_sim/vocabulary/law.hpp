// The law of each row of the vocabulary in double: force per unit coefficient, what it remembers, where it is not smooth,
// and the slopes of all of these. The plant, the fixed-step simulator, the balance of forces and the test of the core's
// fixed-point laws call these; there is no second set.
//
// Inputs by place of the row (firmware::EffectPlace):
//   link     u elongation, w rate of the link (m, m/s; rad, rad/s); force subtracted from end a and added to end b, N (N m)
//   DOF      u, w, a displacement, velocity, acceleration of the DOF; force subtracted from the DOF, N (N m)
//   channel  u the true signal, w its rate; the reading is u + q force (a delay: to its first order); of a force channel
//            that has it, the acting force is the reading minus q force
// z: memory (firmware::Memory); t_s: seconds since the start of the record; shape[]: the row's parameters in the order of the
// row, 0 where left out.
#pragma once
#include <array>
#include <vector>

#include "firmware/vocabulary/effect_table.hpp"

namespace vocabulary {

using firmware::EffectKind;
constexpr int kShapes = firmware::kMaxShapes;
constexpr int kMemories = 2;

struct Shape {
  double p[kShapes] = {0.0, 0.0};
};

struct Point {
  double u = 0.0, w = 0.0, a = 0.0, t_s = 0.0;
  double z[kMemories] = {0.0, 0.0};
  double sign =
      0.0;       // of w; |w| is w sign. An integrator holds it between events; an expected sign lies between -1 and 1
  int side = 0;  // of the gap: -1 below -gap, 0 inside, +1 beyond; held between events
};
// With sign and side as u and w have them (sign of a rate of exactly zero: 0).
Point point(EffectKind kind, double u, double w, double t_s, const Shape& shape);

struct Slopes {  // of a value with respect to each input, sign and side held
  double u = 0.0, w = 0.0, a = 0.0;
  double z[kMemories] = {0.0, 0.0};
  double shape[kShapes] = {0.0, 0.0};
};
struct Force {
  double value = 0.0;  // per unit coefficient
  Slopes slope;
};
struct MemoryRate {  // dz/dt, 1/s times the unit of z
  double value[kMemories] = {0.0, 0.0};
  Slopes slope[kMemories];
};

struct Law {
  EffectKind kind;
  Force (*force)(const Point&, const Shape&);
  int memories;                                                                      // entries of z
  MemoryRate (*memory_rate)(const Point&, const Shape&);                             // nullptr where memories is 0
  void (*start)(const Point&, const Shape&, double* z);                              // see start_memory
  void (*advance)(const Point&, const Point&, double h_s, const Shape&, double* z);  // see advance_memory
};
const Law& law_of(EffectKind kind);

inline Force force(EffectKind kind, const Point& at, const Shape& shape) { return law_of(kind).force(at, shape); }
inline MemoryRate memory_rate(EffectKind kind, const Point& at, const Shape& shape) {
  return law_of(kind).memory_rate(at, shape);
}

// What a memory holds where a record starts, without knowledge of what went before. Bristles are bent all the way in the
// direction of the rate: a link in motion has slid before; at rest they stand upright. A hidden mass rides along.
void start_memory(EffectKind kind, const Point& at, const Shape& shape, double* z);

// z from one sample to the next, h_s later, where the motion between is known at the samples alone: exact for bristles
// if the elongation does not turn in between; for a hidden mass the motion between is the cubic through place and velocity
// at both. from.z is not read.
void advance_memory(EffectKind kind, const Point& from, const Point& to, double h_s, const Shape& shape, double* z);

// Where a law is not smooth: the roots of functions g of the motion. At a root of kRateZero `sign` changes, at those of
// kGap `side`; a sensitivity jumps there as g's slopes say.
struct EventFunction {
  double value = 0.0;
  double u = 0.0, w = 0.0;  // dg/du, dg/dw
  double shape[kShapes] = {0.0, 0.0};
};
int events_of(EffectKind kind);  // 0, 1 (w = 0) or 2 (u = +gap, u = -gap)
EventFunction event_function(EffectKind kind, int event, const Point& at, const Shape& shape);

// The level at which a link at rest holds, per unit coefficient: 1 for friction that carries what it is asked to, else 0.
double hold_level(EffectKind kind);

// How far a drifting coefficient has gone at a time, in s: t, or tau (1 - exp(-t / tau)) where it levels off (tau > 0;
// nought before t = 0).
double drifted_s(double t_s, double time_constant_s);

}  // namespace vocabulary
