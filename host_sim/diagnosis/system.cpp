// The words of the vocabulary, the links a rig has or may lack, and how each moves.
#include <algorithm>
#include <cmath>

#include "terms.hpp"

namespace diagnosis {
namespace {

struct Word {
  Kind kind;
  const char* text;
};
constexpr Word kWords[] = {{Kind::kMass, "mass"},
                           {Kind::kStiffness, "stiffness"},
                           {Kind::kViscous, "viscous"},
                           {Kind::kCoulomb, "coulomb"},
                           {Kind::kGravity, "gravity_torque"},
                           {Kind::kCubicStiffness, "cubic_stiffness"},
                           {Kind::kQuadraticStiffness, "quadratic_stiffness"},
                           {Kind::kStiffnessError, "stiffness_error"},
                           {Kind::kBacklash, "backlash"},
                           {Kind::kEndStop, "end_stop"},
                           {Kind::kQuadraticDamping, "quadratic_damping"},
                           {Kind::kCubicDamping, "cubic_damping"},
                           {Kind::kStribeck, "stribeck"},
                           {Kind::kPresliding, "presliding_hysteresis"},
                           {Kind::kForceOffset, "force_offset"},
                           {Kind::kAsymmetricViscous, "asymmetric_viscous"},
                           {Kind::kDisplacementDamping, "displacement_dependent_damping"},
                           {Kind::kMissingViscous, "missing_viscous"},
                           {Kind::kMissingCoulomb, "missing_coulomb"},
                           {Kind::kDriftingViscous, "drifting_viscous"},
                           {Kind::kCogging, "cogging"},
                           {Kind::kMissingGravity, "missing_gravity_torque"},
                           {Kind::kMassError, "mass_error"},
                           {Kind::kResonance, "unmodelled_resonance"},
                           {Kind::kResonanceCos, "unmodelled_resonance"},
                           {Kind::kResonanceSin, "unmodelled_resonance"},
                           {Kind::kForceDelay, "sensor_delay"},
                           {Kind::kForceGain, "sensor_gain"},
                           {Kind::kDeadBand, "drive_dead_band"},
                           {Kind::kForceHumCos50, "mains_hum"},
                           {Kind::kForceHumSin50, "mains_hum"},
                           {Kind::kForceHumCos60, "mains_hum"},
                           {Kind::kForceHumSin60, "mains_hum"},
                           {Kind::kBaseDelay, "sensor_delay"},
                           {Kind::kChannelDelay, "sensor_delay"},
                           {Kind::kChannelGain, "sensor_gain"},
                           {Kind::kHumCos, "mains_hum"},
                           {Kind::kHumSin, "mains_hum"},
                           {Kind::kUnknownPitch, "unknown"}};

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

const char* word_of(Kind kind) {
  for (const Word& w : kWords)
    if (w.kind == kind) return w.text;
  return "";
}

bool kind_of_word(const std::string& word, Kind* kind) {
  for (const Word& w : kWords)
    if (word == w.text && w.kind >= Kind::kCubicStiffness && w.kind <= Kind::kResonance) return *kind = w.kind, true;
  return false;
}

System make_system(const rig_file::RigModel& rig) {
  System s{rig, rig.links, rig.links.size()};
  const int n = static_cast<int>(rig.dofs.size());
  for (int a = 1; a <= n; ++a)
    for (int b = 0; b <= n; ++b) {
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

}  // namespace diagnosis
