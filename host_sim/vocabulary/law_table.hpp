// The table of laws, in a header so that a simulator's inner loop can inline them. law.hpp is the way in for all others.
#pragma once
#include <utility>

#include "host_sim/vocabulary/force_laws.hpp"
#include "host_sim/vocabulary/law.hpp"
#include "host_sim/vocabulary/memory_laws.hpp"

namespace vocabulary {

constexpr Law plain(EffectKind kind, Force (*force)(const Point&, const Shape&)) {
  return {kind, force, 0, nullptr, nullptr, nullptr};
}

// In the order of the rows.
inline constexpr Law kLaws[] = {
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
    plain(EffectKind::kCogging, laws::cogging),
    plain(EffectKind::kMissingGravityTorque, laws::pendulum),
    plain(EffectKind::kMassError, laws::acceleration),
    {EffectKind::kUnmodelledResonance, laws::hidden_mass, 2, laws::hidden_mass_rate, laws::hidden_mass_at_start,
     laws::move_hidden_mass},
    plain(EffectKind::kSensorDelay, laws::late),
    plain(EffectKind::kSensorGain, laws::elongation),
    plain(EffectKind::kMainsHum, laws::hum),
    plain(EffectKind::kSensorOffset, laws::constant),
    plain(EffectKind::kForceHold, laws::none),
    plain(EffectKind::kDriveDeadBand, laws::within_gap),
    plain(EffectKind::kAcCoupling, laws::none),
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

namespace inner {
template <size_t... I>
inline double value_at(size_t kind, const Point& at, const Shape& shape, std::index_sequence<I...>) {
  double value = 0.0;
  static_cast<void>(((kind == I && (value = kLaws[I].force(at, shape).value, true)) || ...));
  return value;
}
}  // namespace inner

// force(kind, at, shape).value without the slopes.
inline double force_value(EffectKind kind, const Point& at, const Shape& shape) {
  return inner::value_at(static_cast<size_t>(kind), at, shape, std::make_index_sequence<firmware::kEffectKinds>());
}

}  // namespace vocabulary
