// The words of the vocabulary, the links a rig has or may lack, and how each moves.
#include <algorithm>
#include <cmath>

#include "terms.hpp"

namespace diagnosis {
namespace {

using firmware::EffectKind;

struct RowOfKind {
  Kind kind;
  EffectKind effect;
};
constexpr RowOfKind kRows[] = {{Kind::kMass, EffectKind::kMass},
                               {Kind::kStiffness, EffectKind::kStiffness},
                               {Kind::kViscous, EffectKind::kViscous},
                               {Kind::kCoulomb, EffectKind::kCoulomb},
                               {Kind::kGravity, EffectKind::kGravityTorque},
                               {Kind::kCubicStiffness, EffectKind::kCubicStiffness},
                               {Kind::kQuadraticStiffness, EffectKind::kQuadraticStiffness},
                               {Kind::kStiffnessError, EffectKind::kStiffnessError},
                               {Kind::kBacklash, EffectKind::kBacklash},
                               {Kind::kEndStop, EffectKind::kEndStop},
                               {Kind::kQuadraticDamping, EffectKind::kQuadraticDamping},
                               {Kind::kCubicDamping, EffectKind::kCubicDamping},
                               {Kind::kStribeck, EffectKind::kStribeck},
                               {Kind::kPresliding, EffectKind::kPreslidingHysteresis},
                               {Kind::kForceOffset, EffectKind::kForceOffset},
                               {Kind::kAsymmetricViscous, EffectKind::kAsymmetricViscous},
                               {Kind::kDisplacementDamping, EffectKind::kDisplacementDependentDamping},
                               {Kind::kMissingViscous, EffectKind::kMissingViscous},
                               {Kind::kMissingCoulomb, EffectKind::kMissingCoulomb},
                               {Kind::kDriftingViscous, EffectKind::kDriftingViscous},
                               {Kind::kCogging, EffectKind::kCogging},
                               {Kind::kMissingGravity, EffectKind::kMissingGravityTorque},
                               {Kind::kMassError, EffectKind::kMassError},
                               {Kind::kResonance, EffectKind::kUnmodelledResonance},
                               {Kind::kResonanceCos, EffectKind::kUnmodelledResonance},
                               {Kind::kResonanceSin, EffectKind::kUnmodelledResonance},
                               {Kind::kForceDelay, EffectKind::kSensorDelay},
                               {Kind::kForceGain, EffectKind::kSensorGain},
                               {Kind::kDeadBand, EffectKind::kDriveDeadBand},
                               {Kind::kForceHumCos50, EffectKind::kMainsHum},
                               {Kind::kForceHumSin50, EffectKind::kMainsHum},
                               {Kind::kForceHumCos60, EffectKind::kMainsHum},
                               {Kind::kForceHumSin60, EffectKind::kMainsHum},
                               {Kind::kBaseDelay, EffectKind::kSensorDelay},
                               {Kind::kChannelDelay, EffectKind::kSensorDelay},
                               {Kind::kChannelGain, EffectKind::kSensorGain},
                               {Kind::kHumCos, EffectKind::kMainsHum},
                               {Kind::kHumSin, EffectKind::kMainsHum},
                               {Kind::kUnknownPitch, EffectKind::kCogging}};

constexpr bool in_order() {
  int next = 0;
  for (const RowOfKind& row : kRows)
    if (static_cast<int>(row.kind) != next++) return false;
  return next == static_cast<int>(Kind::kUnknownPitch) + 1;
}
static_assert(in_order(), "a row of the vocabulary for each kind, in the order of the kinds");

// Expected sgn of a rate that is known up to a Gaussian error and changes from sample to sample.
Series soft_sign(const Series& rate, double error) {
  Series out(rate.size());
  for (Eigen::Index i = 0; i < rate.size(); ++i) {
    const double before = rate[std::max<Eigen::Index>(i - 1, 0)], after = rate[std::min(i + 1, rate.size() - 1)];
    const double change = 0.5 * (after - before);
    const double spread = std::sqrt(2 * (error * error + change * change / 12));
    out[i] = std::erf(rate[i] / (spread + 1e-300));
  }
  return out;
}

}  // namespace

EffectKind effect_of(Kind kind) { return kRows[static_cast<int>(kind)].effect; }

const char* word_of(Kind kind) {
  return kind == Kind::kUnknownPitch ? "unknown" : firmware::row_of(effect_of(kind)).word.text;
}

bool kind_of_word(const std::string& word, Kind* kind) {
  const auto stands_in_a_rig_file = [](Kind k) {
    return (k >= Kind::kCubicStiffness && k <= Kind::kResonance) || k == Kind::kDeadBand;
  };
  for (const RowOfKind& row : kRows)
    if (word == word_of(row.kind) && stands_in_a_rig_file(row.kind)) return *kind = row.kind, true;
  return false;
}

System make_system(const rig_file::RigModel& rig, bool ground_known) {
  System s{rig, rig.links, rig.links.size()};
  const int n = static_cast<int>(rig.dofs.size());
  for (int a = 1; a <= n; ++a)
    for (int b = ground_known ? rig_file::kGround : 1; b <= n; ++b) {
      if (b == a || (b != 0 && b < a)) continue;
      bool present = false;
      for (const rig_file::Link& l : rig.links) present = present || (l.a == a && l.b == b) || (l.a == b && l.b == a);
      if (present ||
          (b != 0 && rig.dofs[static_cast<size_t>(a - 1)].rotating != rig.dofs[static_cast<size_t>(b - 1)].rotating))
        continue;
      rig_file::Link link;
      link.a = a, link.b = b;
      s.links.push_back(link);
    }
  return s;
}

LinkMotion link_motion(const System& system, const FusedRecord& f, size_t link) {
  LinkMotion m;
  const rig_file::Link& l = system.links[link];
  const Eigen::Index n = static_cast<Eigen::Index>(f.samples);
  m.u = m.w = m.smooth_u = m.smooth_w = Series::Zero(n);
  double variance = 0;
  const auto add = [&](int end, double sign) {
    if (end == rig_file::kGround) return;
    const DofMotion& d = f.motion[end == rig_file::kBase ? system.dofs() : static_cast<size_t>(end - 1)];
    if (!d.measured) throw CannotAnswer(f.file + ": the moving base has no motion channel");
    m.u += sign * d.x, m.w += sign * d.v, m.smooth_u += sign * d.smooth_x, m.smooth_w += sign * d.smooth_v;
    variance += d.smooth_v_error * d.smooth_v_error;
  };
  add(l.a, 1), add(l.b, -1);
  m.w_error = std::sqrt(variance);
  m.sign = soft_sign(m.smooth_w, m.w_error);
  const Series g2 = f.inner.cwiseAbs2();
  m.u_rms = std::sqrt(g2.dot(m.smooth_u.cwiseAbs2()) / f.inner_energy);
  m.w_rms = std::sqrt(g2.dot(m.smooth_w.cwiseAbs2()) / f.inner_energy);
  m.u_peak = f.inner.cwiseProduct(m.smooth_u).cwiseAbs().maxCoeff();
  return m;
}

Place place_of_force(const System& system, const Term& term) {
  return term.link < 0 ? Place{term.dof, -1} : place_of_link(system, static_cast<size_t>(term.link));
}

Place place_of_link(const System& system, size_t index) {
  const rig_file::Link& link = system.links[index];
  return {link.a > 0 ? link.a - 1 : -1, link.b > 0 ? link.b - 1 : -1};
}

}  // namespace diagnosis
