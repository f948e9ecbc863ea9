#include "hal/rig_file/effect_words.hpp"

#include <algorithm>
#include <cmath>

namespace rig_file {
namespace {

using firmware::TermKind;
constexpr EffectPlace kLink = EffectPlace::kLink;
constexpr EffectPlace kDof = EffectPlace::kDof;

}  // namespace

const std::vector<EffectWord>& effect_words() {
  static const std::vector<EffectWord> words = {
      {"cubic_stiffness", kLink, true, TermKind::kCubicStiffness, {}, {}, {}, "N/m^3", "N m/rad^3"},
      {"quadratic_stiffness", kLink, true, TermKind::kQuadraticStiffness, {}, {}, {}, "N/m^2", "N m/rad^2"},
      {"stiffness_error", kLink, true, TermKind::kStiffness, {}, {}, {}, "N/m", "N m/rad"},
      {"backlash", kLink, true, TermKind::kBacklash, {"gap"}, {"m"}, {"rad"}, "N/m", "N m/rad"},
      {"end_stop", kLink, true, TermKind::kEndStop, {"gap"}, {"m"}, {"rad"}, "N/m", "N m/rad"},
      {"quadratic_damping", kLink, true, TermKind::kQuadraticDamping, {}, {}, {}, "N s^2/m^2", "N m s^2/rad^2"},
      {"cubic_damping", kLink, true, TermKind::kCubicDamping, {}, {}, {}, "N s^3/m^3", "N m s^3/rad^3"},
      {"stribeck", kLink, true, TermKind::kStribeck, {"stribeck_velocity"}, {"m_s"}, {"rad_s"}, "N", "N m"},
      {"presliding_hysteresis",
       kLink,
       true,
       TermKind::kPreslidingHysteresis,
       {"presliding_length"},
       {"m"},
       {"rad"},
       "N",
       "N m"},
      {"force_offset", kLink, true, TermKind::kForceOffset, {}, {}, {}, "N", "N m"},
      {"asymmetric_viscous", kLink, true, TermKind::kAsymmetricViscous, {}, {}, {}, "N s/m", "N m s/rad"},
      {"displacement_dependent_damping",
       kLink,
       true,
       TermKind::kDisplacementDependentDamping,
       {},
       {},
       {},
       "N s/m^3",
       "N m s/rad^3"},
      {"missing_viscous", kLink, true, TermKind::kViscous, {}, {}, {}, "N s/m", "N m s/rad"},
      {"missing_coulomb", kLink, true, TermKind::kCoulomb, {}, {}, {}, "N", "N m"},
      {"drifting_viscous",
       kLink,
       true,
       TermKind::kDriftingViscous,
       {"drift_time"},
       {"s"},
       {"s"},
       "N/m",
       "N m/rad",
       true},
      {"mass_error", kDof, true, TermKind::kMass, {}, {}, {}, "kg", "kg m^2"},
      {"unmodelled_resonance",
       kDof,
       false,
       TermKind::kMass,
       {"resonance", "damping_ratio"},
       {"Hz", ""},
       {"Hz", ""},
       "kg",
       "kg m^2"},
  };
  return words;
}

const EffectWord* find_effect_word(const std::string& kind) {
  for (const EffectWord& word : effect_words())
    if (kind == word.kind) return &word;
  return nullptr;
}

std::string shape_key(const EffectWord& word, int index, bool rotating) {
  if (word.shape_keys[index] == nullptr) return "";
  const std::string unit = rotating ? word.rotating_units[index] : word.shape_units[index];
  return std::string(word.shape_keys[index]) + (unit.empty() ? "" : "_" + unit);
}

double first_shape(const Effect& effect, bool rotating) {
  const EffectWord* word = find_effect_word(effect.kind);
  if (word == nullptr) return 0.0;
  const auto found = effect.shape.find(shape_key(*word, 0, rotating));
  return found == effect.shape.end() ? 0.0 : found->second;
}

double drifted_s(double t_s, double time_constant_s) {
  return time_constant_s > 0.0 ? -time_constant_s * std::expm1(-std::max(t_s, 0.0) / time_constant_s) : t_s;
}

}  // namespace rig_file
