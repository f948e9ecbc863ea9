// One consistent motion from displacement, velocity and acceleration of a DOF.
#include <algorithm>
#include <cmath>

#include "motion.hpp"

namespace diagnosis {
namespace {

// Mean of a spectrum's power over +-reach bins.
Series smoothed(const Series& power, Eigen::Index reach) {
  const Eigen::Index n = power.size();
  Series sum(n + 1), out(n);
  sum[0] = 0;
  for (Eigen::Index i = 0; i < n; ++i) sum[i + 1] = sum[i] + power[i];
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index r = std::min(reach, i / 2 + 2);
    const Eigen::Index low = std::max<Eigen::Index>(0, i - r), high = std::min(n - 1, i + r);
    out[i] = (sum[high + 1] - sum[low]) / static_cast<double>(high + 1 - low);
  }
  return out;
}

// 1 up to `pass`, 0 from `stop`, in bins.
double low_pass(Eigen::Index bin, double pass, double stop) {
  const double p = std::clamp((static_cast<double>(bin) - pass) / (stop - pass), 0.0, 1.0);
  return 0.5 * (1 + std::cos(3.141592653589793 * p));
}

DofMotion fuse_dof(const DofSpectra& s, const FusedRecord& f, double energy) {
  DofMotion m;
  m.measured = s.any();
  if (!m.measured) return m;
  const Eigen::Index bins = f.fourier->bins();
  Spectrum y = Spectrum::Zero(bins);
  m.variance = Series::Zero(bins);
  for (Eigen::Index i = 0; i < bins; ++i) {
    double information = 0;
    for (size_t q = 0; q < 3; ++q) {
      if (!s.measured[q]) continue;
      const Complex d = derivative(f.omega(i), static_cast<int>(q));
      y[i] += std::conj(d) * s.z[q][i] / s.noise[q][i];
      information += std::norm(d) / s.noise[q][i];
    }
    const bool known = information > 0 && (s.measured[0] || i >= f.first_bin / 2);
    y[i] = known ? y[i] / information : Complex(0, 0);
    m.variance[i] = known ? 1 / information : 0;
  }
  // expected power of the true displacement, for the weights of the smooth signals
  Series power = y.cwiseAbs2() / energy;
  if (s.measured[0])
    power = smoothed(power, 12);
  else
    power = smoothed(power.cwiseQuotient(m.variance.cwiseMax(1e-300)), 12)
                .cwiseProduct(m.variance);  // integrated noise is steep
  const double pass = 1.3 * static_cast<double>(f.last_bin), stop = 1.8 * static_cast<double>(f.last_bin);
  Spectrum linear(bins), smooth(bins), rate(bins);
  double error = 0;
  m.raw = y;
  m.trust = Series::Zero(bins);
  for (Eigen::Index i = 0; i < bins; ++i) {
    const double truth = std::max(power[i] - m.variance[i], 0.0);
    const double weight = truth / (truth + m.variance[i] + 1e-300);
    smooth[i] = weight * y[i];
    m.trust[i] = weight;
    linear[i] = s.measured[2] ? y[i] : low_pass(i, pass, stop) * y[i];
    error += std::pow(f.omega(i), 2) * weight * m.variance[i] * (i == 0 ? 1 : 2);
  }
  m.smooth_v_error = std::sqrt(error / static_cast<double>(f.samples));
  const auto series = [&](const Spectrum& base, int quantity) {
    for (Eigen::Index i = 0; i < bins; ++i) rate[i] = base[i] * derivative(f.omega(i), quantity);
    return f.fourier->inverse(rate);
  };
  m.x = series(linear, 0), m.v = series(linear, 1), m.a = series(linear, 2);
  m.smooth_x = series(smooth, 0), m.smooth_v = series(smooth, 1), m.smooth_a = series(smooth, 2);
  return m;
}

}  // namespace

Eigen::Index motion_bin(const FusedRecord& f, double share) {
  Series power = Series::Zero(f.last_bin + 1);
  for (const DofMotion& m : f.motion)
    for (Eigen::Index i = 0; m.measured && i <= f.last_bin; ++i)
      power[i] += std::pow(f.omega(i), 2) * std::norm(m.raw[i]);
  const double whole = power.sum();
  double sum = 0;
  Eigen::Index i = 0;
  while (i < f.last_bin && sum < share * whole) sum += power[i++];
  return i;
}

void fuse(FusedRecord& f) {
  const double energy = f.outer.weight.squaredNorm();
  f.motion.clear();
  for (const DofSpectra& s : f.spectra) f.motion.push_back(fuse_dof(s, f, energy));
}

}  // namespace diagnosis
