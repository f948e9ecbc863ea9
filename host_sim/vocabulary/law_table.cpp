#include "host_sim/vocabulary/law_table.hpp"

namespace vocabulary {

const Law& law_of(EffectKind kind) { return kLaws[static_cast<int>(kind)]; }

Point point(EffectKind kind, double u, double w, double t_s, const Shape& shape) {
  Point at;
  at.u = u, at.w = w, at.t_s = t_s;
  at.sign = static_cast<double>((w > 0.0) - (w < 0.0));
  if (row_of(kind).nature.events == firmware::Events::kGap) at.side = (u > shape.p[0]) - (u < -shape.p[0]);
  return at;
}

void start_memory(EffectKind kind, const Point& at, const Shape& shape, double* z) {
  if (law_of(kind).memories > 0) law_of(kind).start(at, shape, z);
}

void advance_memory(EffectKind kind, const Point& from, const Point& to, double h_s, const Shape& shape, double* z) {
  if (law_of(kind).memories > 0) law_of(kind).advance(from, to, h_s, shape, z);
}

int events_of(EffectKind kind) {
  switch (row_of(kind).nature.events) {
    case firmware::Events::kRateZero:
      return 1;
    case firmware::Events::kGap:
      return 2;
    default:
      return 0;
  }
}

EventFunction event_function(EffectKind kind, int event, const Point& at, const Shape& shape) {
  EventFunction g;
  if (row_of(kind).nature.events == firmware::Events::kRateZero) {
    g.value = at.w, g.w = 1.0;
  } else {
    const double side = event == 0 ? 1.0 : -1.0;
    g.value = at.u - side * shape.p[0], g.u = 1.0, g.shape[0] = -side;
  }
  return g;
}

double hold_level(EffectKind kind) { return row_of(kind).nature.at_rest == firmware::AtRest::kHolds ? 1.0 : 0.0; }

double drifted_s(double t_s, double time_constant_s) {
  return time_constant_s > 0.0 ? -time_constant_s * std::expm1(-std::max(t_s, 0.0) / time_constant_s) : t_s;
}

}  // namespace vocabulary
