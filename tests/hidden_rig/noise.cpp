#include "noise.hpp"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace hidden_rig {
namespace {

constexpr double kPi = 3.14159265358979323846;

Values pink(Dice& dice, size_t count) {
  std::vector<std::complex<double>> spectrum(count / 2 + 1);
  for (size_t i = 1; i < spectrum.size(); ++i)
    spectrum[i] = std::complex<double>(dice.gauss(), dice.gauss()) / std::sqrt(static_cast<double>(i));
  Values signal(count);
  fftw_plan plan = fftw_plan_dft_c2r_1d(static_cast<int>(count), reinterpret_cast<fftw_complex*>(spectrum.data()),
                                        signal.data(), FFTW_ESTIMATE);
  fftw_execute(plan);
  fftw_destroy_plan(plan);
  return signal;
}

// Student's t with three degrees of freedom, its variance 3 taken out.
double student(Dice& dice) {
  double chi = 0;
  for (int i = 0; i < 3; ++i) {
    const double g = dice.gauss();
    chi += g * g;
  }
  return dice.gauss() / std::sqrt(chi);
}

}  // namespace

double rms(const Values& v) {
  double sum = 0;
  for (double x : v) sum += x * x;
  return v.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(v.size()));
}

Values draw_noise(Dice& dice, const Condition& c, size_t count) {
  if (c.colour == Colour::kPink) {
    Values noise = pink(dice, count);
    const double level = rms(noise);
    for (double& v : noise) v /= level;
    return noise;
  }
  Values noise(count);
  double state = dice.gauss();
  const double fresh = std::sqrt(1 - c.memory * c.memory);
  for (double& v : noise) {
    v = state;
    state = c.memory * state + fresh * dice.gauss();
    if (c.colour == Colour::kStudent) v = student(dice);
    if (c.colour == Colour::kSpikes && dice.chance(0.01)) v += 10 * dice.sign();
  }
  return noise;
}

Values draw_drift(Dice& dice, size_t count) {
  const double ramp = dice.gauss();
  double size[3], phase[3];
  for (int k = 0; k < 3; ++k) size[k] = dice.gauss(), phase[k] = dice.between(0, 2 * kPi);
  Values drift(count);
  for (size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count);
    drift[i] = ramp * (t - 0.5) * 3;
    for (int k = 0; k < 3; ++k) drift[i] += size[k] * std::sin(2 * kPi * (k + 1) * 1.3 * t + phase[k]);
  }
  const double level = rms(drift);
  for (double& v : drift) v /= level;
  return drift;
}

void low_pass(Values& values, double corner) {
  const double warped = std::tan(kPi * corner);
  for (const double q : {0.541196100146197, 1.306562964876377}) {
    const double a0 = 1 + warped / q + warped * warped;
    const double b0 = warped * warped / a0, a1 = 2 * (warped * warped - 1) / a0,
                 a2 = (1 - warped / q + warped * warped) / a0;
    double x1 = values[0], x2 = x1, y1 = x1, y2 = x1;
    for (double& v : values) {
      const double y = b0 * (v + 2 * x1 + x2) - a1 * y1 - a2 * y2;
      x2 = x1, x1 = v, y2 = y1, y1 = y, v = y;
    }
  }
}

}  // namespace hidden_rig
