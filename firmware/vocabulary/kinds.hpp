// The kinds of force that a rig knows: those of its own terms, those of effects that a model may lack, faults of channels.
#pragma once
#include <cstdint>

namespace firmware {

// A column of the core's equations: the force (or torque) of a term per unit coefficient; for a mass it is the
// acceleration of its DOF. The numbers travel on CAN: new kinds come last.
enum class TermKind : uint8_t {
  kMass,                          // m a
  kStiffness,                     // k u
  kViscous,                       // c w
  kCoulomb,                       // F sgn(w)
  kGravity,                       // G sin(u)
  kCubicStiffness,                // k3 u^3
  kQuadraticStiffness,            // k2 u^2
  kBacklash,                      // k u outside the gap: coefficient -k times clamp(u, -gap, gap); shape = gap
  kEndStop,                       // ke (|u| - gap) sgn(u) beyond the gap; shape = gap
  kQuadraticDamping,              // c2 w |w|
  kCubicDamping,                  // c3 w^3
  kStribeck,                      // Fs exp(-|w| / vs) sgn(w); shape = vs
  kPreslidingHysteresis,          // Dahl force of unit level; shape = presliding length
  kForceOffset,                   // F0
  kAsymmetricViscous,             // c_a |w|: c + c_a for w > 0, c - c_a for w < 0
  kDisplacementDependentDamping,  // c_u u^2 w
  kDriftingViscous,  // c_t w t, t in s since the level's start; shape = time constant tau: c_t w tau (1 - exp(-t / tau))
  kCogging,          // a sin(2 pi u / pitch + phase); shape = pitch, second shape = phase
  kCount
};
constexpr int kTermKinds = static_cast<int>(TermKind::kCount);
// What the force of a term per unit coefficient is: a sign, a law of its own, or else a signal.
constexpr bool is_sign_term(TermKind kind) { return kind == TermKind::kCoulomb; }
constexpr bool is_effect_term(TermKind kind) { return kind >= TermKind::kGravity; }

// A row of the vocabulary (effect_table.hpp), in the table's order; nothing but the order of the rows hangs on the numbers.
enum class EffectKind : uint8_t {
  // a rig file's own terms
  kMass,
  kStiffness,
  kViscous,
  kCoulomb,
  kGravityTorque,
  // effects on a link
  kCubicStiffness,
  kQuadraticStiffness,
  kStiffnessError,
  kBacklash,
  kEndStop,
  kQuadraticDamping,
  kCubicDamping,
  kStribeck,
  kPreslidingHysteresis,
  kForceOffset,
  kAsymmetricViscous,
  kDisplacementDependentDamping,
  kMissingViscous,
  kMissingCoulomb,
  kDriftingViscous,
  kCogging,
  kMissingGravityTorque,
  // effects on a DOF
  kMassError,
  kUnmodelledResonance,
  // faults of a channel
  kSensorDelay,
  kSensorGain,
  kMainsHum,
  kSensorOffset,
  kForceHold,
  kDriveDeadBand,
  kAcCoupling,
  kCount
};
constexpr int kEffectKinds = static_cast<int>(EffectKind::kCount);

}  // namespace firmware
