#include "excitation.hpp"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace hidden_rig {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr double kDeflection_m = 5e-3;
using Spectrum = std::vector<std::complex<double>>;

Values time_signal(Spectrum spectrum, size_t count) {
  Values signal(count);
  fftw_plan plan = fftw_plan_dft_c2r_1d(static_cast<int>(count), reinterpret_cast<fftw_complex*>(spectrum.data()),
                                        signal.data(), FFTW_ESTIMATE);
  fftw_execute(plan);
  fftw_destroy_plan(plan);
  return signal;
}

void scale(Values& values, double factor) {
  for (double& v : values) v *= factor;
}

// Gaussian with a flat band; count at step_s.
Spectrum band(Dice& dice, size_t count, double step_s, double low_Hz, double high_Hz) {
  Spectrum spectrum(count / 2 + 1);
  const double bin = 1 / (static_cast<double>(count) * step_s);
  for (size_t i = 0; i < spectrum.size(); ++i) {
    const double f = static_cast<double>(i) * bin;
    if (f > high_Hz) break;
    if (f >= low_Hz) spectrum[i] = {dice.gauss(), dice.gauss()};
  }
  return spectrum;
}

size_t easy_length(size_t count) {  // the next 2^a 3 or 2^a
  size_t length = 2;
  while (length < count) length *= 2;
  return length * 3 / 4 >= count ? length * 3 / 4 : length;
}

Values band_force(Dice& dice, const Condition& c, size_t count, double step_s, double level) {
  const size_t length = easy_length(count);
  Values force = time_signal(band(dice, length, step_s, 5 * c.pace, 50 * c.pace), length);
  force.resize(count);
  scale(force, level / rms(force));
  return force;
}

void base_motion(Dice& dice, const Condition& c, size_t count, double step_s, double acceleration, Drive& drive) {
  const size_t length = easy_length(count);
  const Spectrum a = band(dice, length, step_s, 5 * c.pace, 50 * c.pace);
  Spectrum v = a, x = a;
  for (size_t i = 1; i < a.size(); ++i) {
    const std::complex<double> jw(0, kTwoPi * static_cast<double>(i) / (static_cast<double>(length) * step_s));
    v[i] = a[i] / jw;
    x[i] = v[i] / jw;
  }
  drive.base_a = time_signal(a, length);
  drive.base_v = time_signal(v, length);
  drive.base_x = time_signal(x, length);
  const double factor = acceleration / rms(drive.base_a);
  for (Values* values : {&drive.base_x, &drive.base_v, &drive.base_a}) {
    scale(*values, factor);
    values->resize(count);
  }
}

Values sine(size_t count, double step_s, double f_Hz, double level) {
  Values force(count);
  for (size_t i = 0; i < count; ++i) force[i] = level * std::sin(kTwoPi * f_Hz * static_cast<double>(i) * step_s);
  return force;
}

Values stepped_sine(size_t count, double step_s, const Shakers& s) {
  Values force(count);
  for (size_t i = 0; i < count; ++i) {
    const size_t dwell = std::min<size_t>(3, 4 * i / count);
    const double f = dwell % 2 == 0 ? s.low_Hz : s.high_Hz, level = s.level * (dwell < 2 ? 1.0 : 2.5);
    force[i] = level * std::sin(kTwoPi * f * static_cast<double>(i) * step_s);
  }
  return force;
}

Values sweep(size_t count, double step_s, double pace, double level) {
  const double total = static_cast<double>(count) * step_s, low = 4 * pace, ratio = std::log(15.0);
  Values force(count);
  for (size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) * step_s;
    force[i] = level * std::sin(kTwoPi * low * total / ratio * (std::exp(ratio * t / total) - 1));
  }
  return force;
}

Values hammer(Dice& dice, size_t count, double step_s, const Condition& c, const Shakers& s) {
  Values force(count, 0.0);
  double t = dice.between(0.1, 0.4) / c.pace;
  while (t < static_cast<double>(count) * step_s) {
    const double width = dice.between(4e-3, 8e-3) / c.pace, peak = s.level * dice.between(3, 10);
    const size_t first = static_cast<size_t>(t / step_s) + 1, last = static_cast<size_t>((t + width) / step_s);
    for (size_t i = first; i <= last && i < count; ++i) {
      const double half = std::sin(0.5 * kTwoPi * (static_cast<double>(i) * step_s - t) / width);
      force[i] += peak * (s.soft_hammer ? half * half : half);
    }
    t += dice.between(1, 2.5) / c.pace;
  }
  return force;
}

// Static deflection under random forces, by Gaussian elimination on the stiffness matrix; its largest entry is kDeflection_m.
std::vector<double> deflected(Dice& dice, const TrueRig& rig) {
  const size_t n = rig.mass_kg.size();
  std::vector<std::vector<double>> m(n, std::vector<double>(n + 1, 0.0));
  for (const TrueLink& l : rig.links) {
    if (l.a >= 0) m[static_cast<size_t>(l.a)][static_cast<size_t>(l.a)] += l.k;
    if (l.b >= 0) m[static_cast<size_t>(l.b)][static_cast<size_t>(l.b)] += l.k;
    if (l.a >= 0 && l.b >= 0) {
      m[static_cast<size_t>(l.a)][static_cast<size_t>(l.b)] -= l.k;
      m[static_cast<size_t>(l.b)][static_cast<size_t>(l.a)] -= l.k;
    }
  }
  for (size_t i = 0; i < n; ++i) m[i][n] = dice.gauss();
  for (size_t p = 0; p < n; ++p)
    for (size_t r = 0; r < n; ++r) {
      if (r == p) continue;
      const double factor = m[r][p] / m[p][p];
      for (size_t col = p; col <= n; ++col) m[r][col] -= factor * m[p][col];
    }
  std::vector<double> x(n);
  double peak = 0;
  for (size_t i = 0; i < n; ++i) {
    x[i] = m[i][n] / m[i][i];
    peak = std::max(peak, std::abs(x[i]));
  }
  for (double& value : x) value *= kDeflection_m / peak;
  return x;
}

}  // namespace

Shakers draw_shakers(Dice& dice, const Condition& c, const TrueRig& rig) {
  const int n = static_cast<int>(rig.mass_kg.size());
  Shakers s;
  s.dof = {dice.chance(0.5) ? 0 : dice.below(n)};
  if (c.excitation == Excitation::kTwoShakers) s.dof = {0, n - 1};
  s.level = dice.log_between(10, 40) * c.mass_scale * c.pace * c.pace;
  s.low_Hz = dice.between(6, 15) * c.pace;
  s.high_Hz = s.low_Hz * dice.between(1.4, 3);
  s.soft_hammer = dice.chance(0.5);
  return s;
}

Drive draw_drive(Dice& dice, const Condition& c, const TrueRig& rig, const Shakers& s, int record, size_t samples) {
  Drive drive;
  drive.sample_period_s = 1 / c.rate_Hz;
  drive.substeps = std::max(1, static_cast<int>(std::ceil(4000 * c.pace / c.rate_Hz)));
  const size_t count = (samples + 2) * 2 * static_cast<size_t>(drive.substeps);
  const double step_s = drive.sample_period_s / (2 * drive.substeps);
  const double factor = std::pow(c.level_ratio, record), large = c.rotating ? 150 : 1;
  drive.force_N.resize(rig.mass_kg.size());
  const bool decays = c.excitation == Excitation::kFreeDecay || c.excitation == Excitation::kFreeDecayToRest;
  if (decays) {
    drive.start_x = deflected(dice, rig);
    for (double& x : drive.start_x) x *= factor * large * dice.between(0.8, 1.2);
    drive.start_v.assign(rig.mass_kg.size(), 0.0);
  }
  if (c.excitation == Excitation::kBase)
    base_motion(dice, c, count, step_s, s.level / (1.5 * c.mass_scale) * factor * large, drive);
  if (decays || c.excitation == Excitation::kBase) return drive;
  for (const int dof : s.dof) {
    Values force;
    if (c.excitation == Excitation::kSteppedSine) force = stepped_sine(count, step_s, s);
    if (c.excitation == Excitation::kSineRecords)
      force = sine(count, step_s, record % 2 == 0 ? s.low_Hz : s.high_Hz, s.level * (record < 2 ? 1.0 : 2.5));
    if (c.excitation == Excitation::kSweep) force = sweep(count, step_s, c.pace, s.level);
    if (c.excitation == Excitation::kHammer) force = hammer(dice, count, step_s, c, s);
    if (force.empty()) force = band_force(dice, c, count, step_s, s.level);
    scale(force, factor * large);
    drive.force_N[static_cast<size_t>(dof)] = force;
  }
  return drive;
}

}  // namespace hidden_rig
