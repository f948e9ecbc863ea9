#include "terms.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/vocabulary/law_table.hpp"

namespace diagnosis {
namespace {

// Friction of unit level from bristles that bend over a length, between samples with the mean rate.
Series bristles(const Series& w, double length, double time_s, double period_s) {
  constexpr firmware::EffectKind kBristles = firmware::EffectKind::kPreslidingHysteresis;
  const vocabulary::Shape shape{{length, time_s}};
  Series force(w.size());
  vocabulary::Point at = vocabulary::point(kBristles, 0, w[0], 0, shape);
  vocabulary::start_memory(kBristles, at, shape, at.z);
  for (Eigen::Index i = 0; i < w.size(); ++i) {
    const double next = i + 1 < w.size() ? w[i + 1] : w[i];
    at.w = w[i], at.sign = static_cast<double>((w[i] > 0) - (w[i] < 0));
    force[i] = vocabulary::force_value(kBristles, at, shape);
    vocabulary::Point to;
    to.u = 0.5 * (w[i] + next) * period_s;
    vocabulary::advance_memory(kBristles, vocabulary::Point(), to, period_s, shape, at.z);
  }
  return force;
}

// Acceleration of a hidden mass on a spring driven by the motion x, v (semi-exact: trapezoidal rule).
Series hidden_mass(const Series& x, const Series& v, double frequency_Hz, double ratio, double period_s) {
  const double o = kTwoPi * frequency_Hz, c = 2 * ratio * o, k = o * o, h = period_s,
               yield = 1 / (1 + 0.5 * h * c + 0.25 * h * h * k);
  Series out(x.size());
  double z = x[0], s = v[0], drive = c * v[0] + k * x[0], a = drive - c * s - k * z;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    out[i] = a;
    if (i + 1 == x.size()) break;
    const double next = c * v[i + 1] + k * x[i + 1];  // Newmark, average acceleration
    const double zp = z + h * s + 0.25 * h * h * a, sp = s + 0.5 * h * a;
    a = (next - c * sp - k * zp) * yield;
    z = zp + 0.25 * h * h * a;
    s = sp + 0.5 * h * a;
  }
  return out;
}

// exp(-decay t) cos(omega t + phase), turned on from sample to sample: many times faster than a cosine each, and after a
// million samples right to 1e-10.
Series tone(const FusedRecord& f, double omega, double phase, double decay = 0) {
  const Complex turn = std::exp(Complex(-decay, omega) * f.period_s);
  double real = std::cos(phase), imaginary = std::sin(phase);
  Series s(static_cast<Eigen::Index>(f.samples));
  for (double& value : s) {
    value = real;
    const double next = real * turn.real() - imaginary * turn.imag();
    imaginary = real * turn.imag() + imaginary * turn.real(), real = next;
  }
  return s;
}

Series free_decay(const Term& t, const FusedRecord& f, double phase) {
  const double omega = kTwoPi * t.shape;
  return tone(f, omega, -phase, t.shape2 * omega);
}

// The law of a link's term along the smoothed motion; the sign of a rate is the expected one.
Series force_along(const Term& t, const LinkMotion& l, const FusedRecord& f) {
  const firmware::EffectKind effect = effect_of(t.kind);
  const vocabulary::Shape shape{{t.shape, t.shape2}};
  Series force(l.smooth_u.size());
  for (Eigen::Index i = 0; i < force.size(); ++i) {
    const double u = l.smooth_u[i], w = l.smooth_w[i];
    vocabulary::Point at;
    at.u = u, at.w = w, at.t_s = static_cast<double>(i) * f.period_s;
    at.sign = t.kind == Kind::kStribeck ? l.sign[i] : static_cast<double>((w > 0) - (w < 0));
    at.side = (u > t.shape) - (u < -t.shape);
    force[i] = vocabulary::force_value(effect, at, shape);
  }
  return force;
}

}  // namespace

Series lateness(const Series& force, double delay_s, const FusedRecord& f) {
  Spectrum s = f.fourier->forward(f.outer.weight.cwiseProduct(force));
  for (Eigen::Index i = 0; i < s.size(); ++i) {
    const Complex slope(0, f.omega(i));
    s[i] *= i > 2 * f.last_bin ? 0 : delay_s == 0 ? -slope : (1.0 - std::exp(slope * delay_s)) / delay_s;
  }
  return f.fourier->inverse(s);
}

Series term_force(const Term& t, const FusedRecord& f, const std::vector<LinkMotion>& links) {
  if (t.link < 0) {
    const DofMotion& d = f.motion[static_cast<size_t>(t.dof)];
    const Series* force = &f.force[static_cast<size_t>(t.dof)];
    const auto hum = [&](double hertz, double phase) { return tone(f, kTwoPi * hertz, phase); };
    switch (t.kind) {
      case Kind::kMass:
        return t.smooth ? d.smooth_a : d.a;
      case Kind::kMassError:
        return d.smooth_a;
      case Kind::kResonanceCos:
        return free_decay(t, f, 0);
      case Kind::kResonanceSin:
        return free_decay(t, f, kTwoPi / 4);
      case Kind::kResonance:
        return hidden_mass(d.smooth_x, d.smooth_v, t.shape, t.shape2, f.period_s);
      case Kind::kForceGain:
        return *force;
      case Kind::kDeadBand:
        return force->array().max(-t.shape).min(t.shape).matrix();
      case Kind::kForceDelay:
        return lateness(*force, t.shape, f);
      case Kind::kForceHumCos50:
        return hum(50, 0);
      case Kind::kForceHumSin50:
        return hum(50, kTwoPi / 4);
      case Kind::kForceHumCos60:
        return hum(60, 0);
      case Kind::kForceHumSin60:
        return hum(60, kTwoPi / 4);
      default:
        return Series::Zero(static_cast<Eigen::Index>(f.samples));
    }
  }
  const LinkMotion& l = links[static_cast<size_t>(t.link)];
  switch (t.kind) {
    case Kind::kStiffness:
      return t.smooth ? l.smooth_u : l.u;
    case Kind::kStiffnessError:
      return l.smooth_u;
    case Kind::kViscous:
      return t.smooth ? l.smooth_w : l.w;
    case Kind::kMissingViscous:
      return l.smooth_w;
    case Kind::kCoulomb:
    case Kind::kMissingCoulomb:
      return l.sign;
    case Kind::kPresliding:
      if (t.given) return bristles(l.smooth_w, t.shape, t.shape2, f.period_s);
      return bristles(l.smooth_w, t.shape, t.shape2, f.period_s) - l.sign;
    case Kind::kBacklash:
      return (t.given ? 1.0 : -1.0) * force_along(t, l, f);
    default:
      return force_along(t, l, f);
  }
}

}  // namespace diagnosis
