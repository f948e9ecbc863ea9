// Force laws of hidden effects on links.
#pragma once
#include "true_rig.hpp"

namespace hidden_rig {

enum class Law {
  kNone,  // not a law of a link: friction shapes, effects on a DOF, faults of the measurement
  kCubicStiffness,
  kQuadraticStiffness,
  kStiffnessError,
  kBacklash,
  kEndStop,
  kQuadraticDamping,
  kCubicDamping,
  kForceOffset,
  kAsymmetricViscous,
  kDisplacementDependentDamping,
  kMissingViscous,
  kDriftingViscous,
  kCogging,
  kMissingGravityTorque,
  kPreslidingHysteresis,
  kMissingCoulomb,
  kStribeck,
  kMassError,
  kUnmodelledResonance,
  kDriveDeadBand
};

Law law_of(const std::string& kind);

// Force of the laws that follow from elongation u, rate w and time alone; time runs from 0 to 1 over the record. k is the
// link's stiffness. Zero for the others.
double law_force(Law law, const TrueEffect& effect, double k, double u, double w, double record_share);

}  // namespace hidden_rig
