#include "effect_force.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace hidden_rig {
namespace {

constexpr double kTwoPi = 6.283185307179586;

// From -0.5 to 0.5 in a straight line, or levelling off with the time constant tau (a share of the record); without a mean.
double drift(double tau, double t) {
  if (!(tau > 0)) return t - 0.5;
  return tau * (1 - std::exp(-1 / tau)) - std::exp(-t / tau);
}

}  // namespace

Law law_of(const std::string& kind) {
  static const std::map<std::string, Law> laws = {
      {"cubic_stiffness", Law::kCubicStiffness},
      {"quadratic_stiffness", Law::kQuadraticStiffness},
      {"stiffness_error", Law::kStiffnessError},
      {"backlash", Law::kBacklash},
      {"end_stop", Law::kEndStop},
      {"quadratic_damping", Law::kQuadraticDamping},
      {"cubic_damping", Law::kCubicDamping},
      {"force_offset", Law::kForceOffset},
      {"asymmetric_viscous", Law::kAsymmetricViscous},
      {"displacement_dependent_damping", Law::kDisplacementDependentDamping},
      {"missing_viscous", Law::kMissingViscous},
      {"drifting_viscous", Law::kDriftingViscous},
      {"cogging", Law::kCogging},
      {"missing_gravity_torque", Law::kMissingGravityTorque},
      {"presliding_hysteresis", Law::kPreslidingHysteresis},
      {"missing_coulomb", Law::kMissingCoulomb},
      {"stribeck", Law::kStribeck},
      {"mass_error", Law::kMassError},
      {"unmodelled_resonance", Law::kUnmodelledResonance},
      {"drive_dead_band", Law::kDriveDeadBand},
  };
  const auto found = laws.find(kind);
  return found == laws.end() ? Law::kNone : found->second;
}

double law_force(Law law, const TrueEffect& e, double k, double u, double w, double record_share) {
  const auto inside_gap = [&] { return std::clamp(u, -e.shape, e.shape); };
  switch (law) {
    case Law::kCubicStiffness:
      return e.strength * u * u * u;
    case Law::kQuadraticStiffness:
      return e.strength * u * u;
    case Law::kStiffnessError:
      return e.strength * u;
    case Law::kBacklash:
      return -k * inside_gap();
    case Law::kEndStop:
      return e.strength * (u - inside_gap());
    case Law::kQuadraticDamping:
      return e.strength * w * std::abs(w);
    case Law::kCubicDamping:
      return e.strength * w * w * w;
    case Law::kForceOffset:
      return e.strength;
    case Law::kAsymmetricViscous:
      return e.strength * std::abs(w);
    case Law::kDisplacementDependentDamping:
      return e.strength * u * u * w;
    case Law::kMissingViscous:
      return e.strength * w;
    case Law::kDriftingViscous:
      return e.strength * w * drift(e.shape, std::clamp(record_share, 0.0, 1.0));
    case Law::kCogging:
      return e.strength * std::sin(kTwoPi * u / e.shape + e.phase);
    case Law::kMissingGravityTorque:
      return e.strength * std::sin(u);
    default:
      return 0;
  }
}

}  // namespace hidden_rig
