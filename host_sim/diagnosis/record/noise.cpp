// The noise of each channel, from the record itself.
#include <algorithm>
#include <cmath>

#include "host_sim/records/median.hpp"
#include "motion.hpp"

namespace diagnosis {
namespace {

// Spectrum over frequency of first-order noise with this corner, one far above it; without a corner white.
struct Colour {
  double keep = 0;  // exp(-2 pi corner period); 0: white
  double operator()(double omega_period) const { return 1 / (1 - 2 * keep * std::cos(omega_period) + keep * keep); }
};

// Variance per sample, relative to the colour, from the periodogram between two fractions of the sampling rate, where no
// motion is expected.
double band_variance(const Spectrum& z, double low, double high, double energy, const Colour& colour = {}) {
  std::vector<double> power;
  const double bins = static_cast<double>(2 * (z.size() - 1));
  for (Eigen::Index i = static_cast<Eigen::Index>(low * bins); i < static_cast<Eigen::Index>(high * bins); ++i)
    power.push_back(std::norm(z[i]) / colour(kTwoPi * static_cast<double>(i) / bins));
  return host_sim::median(power) / kMedianOfSpread / energy;
}

// White noise is as strong everywhere; first-order noise seven times weaker at the end of the free band than at its start;
// motion that friction or a weak sensor shows up there falls still faster.
bool falls_with_frequency(const Spectrum& z) {
  const double ratio = band_variance(z, 0.12, 0.18, 1) / std::max(1e-300, band_variance(z, 0.4, 0.48, 1));
  return ratio > 2.2 && ratio < 12;
}

// Variance s that makes s + known most likely for these powers (Whittle), outliers held back.
double excess_variance(const std::vector<double>& power, const std::vector<double>& known, double high) {
  double low = 0;
  for (int i = 0; i < 50; ++i) {
    const double mid = 0.5 * (low + high);
    double slope = 0;
    for (size_t j = 0; j < power.size(); ++j) {
      const double ratio = std::min(power[j] / (mid + known[j]), 7.0);
      slope += (ratio - 1 + std::exp(-7.0)) / (mid + known[j]);  // a clipped exponential has mean 1 - e^-7
    }
    (slope > 0 ? low : high) = mid;
  }
  return 0.5 * (low + high);
}

// Variance of a channel from what another one, of known variance, does not explain of it.
double unexplained(const FusedRecord& f, const DofSpectra& s, size_t channel, size_t other, double other_variance,
                   double highest, const std::array<Colour, 3>& colour) {
  const double energy = f.outer.weight.squaredNorm();
  std::vector<double> power, known;
  for (Eigen::Index i = std::max<Eigen::Index>(1, f.first_beyond(0.5 * f.slow_Hz)); i <= f.last_bin; ++i) {
    const Complex ratio =
        derivative(f.omega(i), static_cast<int>(channel)) / derivative(f.omega(i), static_cast<int>(other));
    const double phase = f.omega(i) * f.period_s, own = colour[channel](phase);
    power.push_back(std::norm(s.z[channel][i] - ratio * s.z[other][i]) / energy / own);
    known.push_back(std::norm(ratio) * other_variance * colour[other](phase) / own);
  }
  return excess_variance(power, known, highest);
}

void set_noise(FusedRecord& f, DofSpectra& s, const std::array<Colour, 3>& colour) {
  const double energy = f.outer.weight.squaredNorm();
  std::array<double, 3> variance{};
  for (size_t q = 0; q < 3; ++q)
    if (s.measured[q]) variance[q] = band_variance(s.z[q], 0.3, 0.48, energy, colour[q]);
  // The high band of an acceleration holds the jumps of friction; its noise is what the slower channels do not explain.
  if (s.measured[2] && (s.measured[0] || s.measured[1])) {
    const size_t other = s.measured[1] ? 1 : 0;
    variance[2] = std::max(0.02 * variance[2], unexplained(f, s, 2, other, variance[other], 1.2 * variance[2], colour));
  }
  for (size_t q = 0; q < 3; ++q)
    if (s.measured[q] && (q > 0 || s.count() > 1))
      variance[q] = std::max(variance[q], kFinest * kFinest * mean_square(s.z[q], energy));
  for (size_t q = 0; q < 3; ++q) {
    if (!s.measured[q]) continue;
    s.noise[q].resize(s.z[q].size());
    for (Eigen::Index i = 0; i < s.noise[q].size(); ++i)
      s.noise[q][i] = std::max(variance[q], 1e-300) * colour[q](f.omega(i) * f.period_s);
  }
}

// How likely the noise makes what the channels of a DOF disagree about (Whittle). An acceleration counts only where it is
// one of two: friction makes it jump, which sampling folds back into the band.
double likelihood(const FusedRecord& f, const DofSpectra& s) {
  const double energy = f.outer.weight.squaredNorm();
  const size_t counted = s.measured[0] && s.measured[1] ? 2 : 3;
  double sum = 0;
  for (Eigen::Index i = f.first_beyond(f.slow_Hz); i <= f.last_bin; ++i) {
    double information = 0, power = 0, scale = 0;
    Complex motion = 0;
    for (size_t q = 0; q < counted; ++q) {
      if (!s.measured[q]) continue;
      const Complex d = derivative(f.omega(i), static_cast<int>(q));
      information += std::norm(d) / s.noise[q][i], motion += std::conj(d) * s.z[q][i] / s.noise[q][i];
      power += std::norm(s.z[q][i]) / s.noise[q][i], scale += std::log(s.noise[q][i]);
    }
    sum -= scale + std::log(information) + (power - std::norm(motion) / information) / energy;
  }
  return sum;
}

// The noise of every channel for one corner of those that are coloured; its likelihood.
double set_all(FusedRecord& f, const std::vector<std::array<bool, 3>>& coloured, double corner_Hz) {
  const Colour colour{std::exp(-kTwoPi * corner_Hz * f.period_s)};
  double sum = 0;
  for (size_t d = 0; d < f.spectra.size(); ++d) {
    std::array<Colour, 3> own{};
    for (size_t q = 0; q < 3; ++q)
      if (coloured[d][q]) own[q] = colour;
    set_noise(f, f.spectra[d], own);
    if (f.spectra[d].count() > 1) sum += likelihood(f, f.spectra[d]);
  }
  return sum;
}

}  // namespace

void estimate_noise(FusedRecord& f) {
  std::vector<std::array<bool, 3>> coloured;
  bool any = false;
  for (const DofSpectra& s : f.spectra) {
    const bool falls = s.measured[0] ? falls_with_frequency(s.z[0]) : s.measured[1] && falls_with_frequency(s.z[1]);
    coloured.push_back({falls, falls, falls});
    any = any || (s.count() > 1 && falls);
  }
  double corner_Hz = 0.02 / f.period_s;
  if (any) {  // above its corner all first-order noise looks alike: where the corner is, the channels' disagreement tells
    double best = -1e300;
    for (double trial = corner_Hz; trial > 5e-4 / f.period_s; trial *= 0.93) {
      const double l = set_all(f, coloured, trial);
      if (l > best) best = l, corner_Hz = trial;
    }
  } else {
    for (auto& c : coloured) c = {};  // what falls with frequency may be motion
  }
  set_all(f, coloured, corner_Hz);
  const double energy = f.outer.weight.squaredNorm();
  f.force_noise.assign(f.force.size(), Series());
  for (size_t i = 0; i < f.force.size(); ++i) {
    if (f.force[i].size() == 0) continue;
    const Spectrum z = f.fourier->forward(f.outer.weight.cwiseProduct(f.force[i]));
    const Colour colour{any && falls_with_frequency(z) ? std::exp(-kTwoPi * corner_Hz * f.period_s) : 0};
    const double variance =
        std::max(band_variance(z, 0.3, 0.48, energy, colour), kFinest * kFinest * mean_square(z, energy));
    f.force_noise[i].resize(z.size());
    for (Eigen::Index k = 0; k < z.size(); ++k) f.force_noise[i][k] = variance * colour(f.omega(k) * f.period_s);
  }
}

}  // namespace diagnosis
