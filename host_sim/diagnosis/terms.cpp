#include "terms.hpp"

#include <algorithm>
#include <cmath>

#include "hal/configuration/effect_words.hpp"

namespace diagnosis {
namespace {

constexpr double kTwoPi = 6.283185307179586;

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
                           {Kind::kMassError, "mass_error"},
                           {Kind::kResonance, "unmodelled_resonance"},
                           {Kind::kResonanceCos, "unmodelled_resonance"},
                           {Kind::kResonanceSin, "unmodelled_resonance"},
                           {Kind::kForceDelay, "sensor_delay"},
                           {Kind::kForceGain, "sensor_gain"},
                           {Kind::kForceHumCos50, "mains_hum"},
                           {Kind::kForceHumSin50, "mains_hum"},
                           {Kind::kForceHumCos60, "mains_hum"},
                           {Kind::kForceHumSin60, "mains_hum"},
                           {Kind::kUnknownPitch, "unknown"},
                           {Kind::kUnknownTime, "unknown"},
                           {Kind::kUnknownTone, "unknown"}};

// Friction of unit level from bristles that bend over a length: z of Dahl, and of LuGre what damps the bristles.
Series bristles(const Series& w, double length, double time_s, double period_s) {
  Series z(w.size());
  double state = 0;
  for (Eigen::Index i = 0; i < w.size(); ++i) {
    const double next = i + 1 < w.size() ? w[i + 1] : w[i];
    z[i] = state + time_s * (w[i] - std::abs(w[i]) * state) / length;
    // exact over a sample with the mean rate: z relaxes towards sgn(w) over the length
    const double mean = 0.5 * (w[i] + next), way = mean < 0 ? -1 : 1;
    state = way + (state - way) * std::exp(-std::abs(mean) * period_s / length);
  }
  return z;
}

// Acceleration of a hidden mass on a spring driven by the motion x, v (semi-exact: trapezoidal rule).
Series hidden_mass(const Series& x, const Series& v, double frequency_Hz, double ratio, double period_s) {
  const double o = kTwoPi * frequency_Hz, c = 2 * ratio * o, k = o * o, h = period_s;
  Series out(x.size());
  double z = x[0], s = v[0], drive = c * v[0] + k * x[0], a = drive - c * s - k * z;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    out[i] = a;
    if (i + 1 == x.size()) break;
    const double next = c * v[i + 1] + k * x[i + 1];  // Newmark, average acceleration
    const double zp = z + h * s + 0.25 * h * h * a, sp = s + 0.5 * h * a;
    a = (next - c * sp - k * zp) / (1 + 0.5 * h * c + 0.25 * h * h * k);
    z = zp + 0.25 * h * h * a;
    s = sp + 0.5 * h * a;
  }
  return out;
}

Series time_axis(const FusedRecord& f) {
  return Series::LinSpaced(static_cast<Eigen::Index>(f.samples), 0, static_cast<double>(f.samples - 1) * f.period_s);
}

Series free_decay(const Term& t, const FusedRecord& f, double phase) {
  const double omega = kTwoPi * t.shape;
  return ((-t.shape2 * omega * time_axis(f).array()).exp() * (omega * time_axis(f).array() - phase).cos()).matrix();
}

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
      if (present || (b != 0 && rig.dofs[static_cast<size_t>(a - 1)].rotating != rig.dofs[static_cast<size_t>(b - 1)].rotating))
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

Series term_force(const Term& t, const FusedRecord& f, const std::vector<LinkMotion>& links) {
  if (t.link < 0) {
    const DofMotion& d = f.motion[static_cast<size_t>(t.dof)];
    const Series* force = &f.force[static_cast<size_t>(t.dof)];
    const auto tone = [&](double hertz, double phase) -> Series {
      return (kTwoPi * hertz * time_axis(f).array() + phase).cos().matrix();
    };
    switch (t.kind) {
      case Kind::kMass: return t.smooth ? d.smooth_a : d.a;
      case Kind::kMassError: return d.smooth_a;
      case Kind::kResonanceCos: return free_decay(t, f, 0);
      case Kind::kResonanceSin: return free_decay(t, f, kTwoPi / 4);
      case Kind::kResonance: return hidden_mass(d.smooth_x, d.smooth_v, t.shape, t.shape2, f.period_s);
      case Kind::kForceGain: return *force;
      case Kind::kForceDelay: {
        Series slope = Series::Zero(force->size());
        for (Eigen::Index i = 1; i + 1 < slope.size(); ++i) slope[i] = ((*force)[i + 1] - (*force)[i - 1]) / (2 * f.period_s);
        return slope;
      }
      case Kind::kForceHumCos50: return tone(50, 0);
      case Kind::kForceHumSin50: return tone(50, kTwoPi / 4);
      case Kind::kForceHumCos60: return tone(60, 0);
      case Kind::kForceHumSin60: return tone(60, kTwoPi / 4);
      case Kind::kUnknownTone: return tone(t.shape, t.shape2);
      default: return Series::Zero(static_cast<Eigen::Index>(f.samples));
    }
  }
  const LinkMotion& l = links[static_cast<size_t>(t.link)];
  const auto u = l.smooth_u.array(), w = l.smooth_w.array();
  switch (t.kind) {
    case Kind::kStiffness: return t.smooth ? l.smooth_u : l.u;
    case Kind::kStiffnessError: return l.smooth_u;
    case Kind::kViscous: return t.smooth ? l.smooth_w : l.w;
    case Kind::kMissingViscous: return l.smooth_w;
    case Kind::kCoulomb: case Kind::kMissingCoulomb: return l.sign;
    case Kind::kGravity: return u.sin().matrix();
    case Kind::kCubicStiffness: return u.cube().matrix();
    case Kind::kQuadraticStiffness: return u.square().matrix();
    case Kind::kBacklash: return (t.given ? -1.0 : 1.0) * u.max(-t.shape).min(t.shape).matrix();
    case Kind::kEndStop: return (u - u.max(-t.shape).min(t.shape)).matrix();
    case Kind::kQuadraticDamping: return (w * w.abs()).matrix();
    case Kind::kCubicDamping: return w.cube().matrix();
    case Kind::kStribeck:
      return ((-w.abs() / t.shape).exp() * l.sign.array()).matrix();
    case Kind::kPresliding:
      if (t.given) return bristles(l.smooth_w, t.shape, t.shape2, f.period_s);
      return bristles(l.smooth_w, t.shape, t.shape2, f.period_s) - l.sign;
    case Kind::kForceOffset: return Series::Ones(u.size());
    case Kind::kAsymmetricViscous: return w.abs().matrix();
    case Kind::kDisplacementDamping: return (u.square() * w).matrix();
    case Kind::kDriftingViscous: return time_axis(f).unaryExpr([&](double t_s) { return rig_file::drifted_s(t_s, t.shape); }).cwiseProduct(l.smooth_w);
    case Kind::kUnknownPitch: return (kTwoPi * u / t.shape + t.shape2).sin().matrix();
    case Kind::kUnknownTime: return ((kTwoPi * time_axis(f).array() / t.shape + t.shape2).sin() * l.w.array()).matrix();
    default: return Series::Zero(u.size());
  }
}

}  // namespace diagnosis
