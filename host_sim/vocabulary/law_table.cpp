#include "host_sim/vocabulary/force_laws.hpp"
#include "host_sim/vocabulary/law.hpp"
#include "host_sim/vocabulary/memory_laws.hpp"

namespace vocabulary {
namespace {

constexpr Law plain(EffectKind kind, Force (*force)(const Point&, const Shape&)) {
  return {kind, force, 0, nullptr, nullptr, nullptr};
}

// In the order of the rows.
constexpr Law kLaws[] = {
    plain(EffectKind::kMass, laws::acceleration),
    plain(EffectKind::kStiffness, laws::elongation),
    plain(EffectKind::kViscous, laws::rate),
    plain(EffectKind::kCoulomb, laws::dry_friction),
    plain(EffectKind::kGravityTorque, laws::pendulum),
    plain(EffectKind::kCubicStiffness, laws::cubic_spring),
    plain(EffectKind::kQuadraticStiffness, laws::quadratic_spring),
    plain(EffectKind::kStiffnessError, laws::elongation),
    plain(EffectKind::kBacklash, laws::gap_lost),
    plain(EffectKind::kEndStop, laws::beyond_gap),
    plain(EffectKind::kQuadraticDamping, laws::quadratic_damper),
    plain(EffectKind::kCubicDamping, laws::cubic_damper),
    plain(EffectKind::kStribeck, laws::stribeck),
    {EffectKind::kPreslidingHysteresis, laws::bristles, 1, laws::bristle_rate, laws::bristles_at_start,
     laws::bend_bristles},
    plain(EffectKind::kForceOffset, laws::constant),
    plain(EffectKind::kAsymmetricViscous, laws::one_way_damper),
    plain(EffectKind::kDisplacementDependentDamping, laws::displaced_damper),
    plain(EffectKind::kMissingViscous, laws::rate),
    plain(EffectKind::kMissingCoulomb, laws::dry_friction),
    plain(EffectKind::kDriftingViscous, laws::drifting_damper),
    plain(EffectKind::kMassError, laws::acceleration),
    {EffectKind::kUnmodelledResonance, laws::hidden_mass, 2, laws::hidden_mass_rate, laws::hidden_mass_at_start,
     laws::move_hidden_mass},
    plain(EffectKind::kSensorDelay, laws::late),
    plain(EffectKind::kSensorGain, laws::elongation),
    plain(EffectKind::kMainsHum, laws::hum),
    plain(EffectKind::kSensorOffset, laws::constant),
    plain(EffectKind::kForceHold, nullptr),
};

constexpr bool a_law_for_each_row() {
  for (int i = 0; i < firmware::kEffectKinds; ++i) {
    if (static_cast<int>(kLaws[i].kind) != i) return false;
    const firmware::Memory memory = firmware::kEffectTable[i].nature.memory;
    const int states = memory == firmware::Memory::kBristles ? 1 : (memory == firmware::Memory::kHiddenMass ? 2 : 0);
    if (kLaws[i].memories != states) return false;
  }
  return true;
}
static_assert(sizeof(kLaws) / sizeof(kLaws[0]) == firmware::kEffectKinds, "one law for each row of the vocabulary");
static_assert(a_law_for_each_row(), "laws in the order of the rows, with the memory that their rows name");

}  // namespace

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
