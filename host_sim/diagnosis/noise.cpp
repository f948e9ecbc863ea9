// The noise of each channel, from the record itself.
#include <algorithm>
#include <cmath>

#include "motion.hpp"

namespace diagnosis {
namespace {

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

constexpr double kMedianOfExponential = 0.6931471805599453;

// Variance per sample from the periodogram between two fractions of the sampling rate, where no motion is expected.
double band_variance(const Spectrum& z, double low, double high, double energy) {
  std::vector<double> power;
  const double bins = static_cast<double>(2 * (z.size() - 1));
  for (Eigen::Index i = static_cast<Eigen::Index>(low * bins); i < static_cast<Eigen::Index>(high * bins); ++i)
    power.push_back(std::norm(z[i]));
  return median(power) / kMedianOfExponential / energy;
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

}  // namespace

void estimate_noise(FusedRecord& f) {
  const double energy = f.outer.weight.squaredNorm();
  for (DofSpectra& s : f.spectra) {
    std::array<double, 3> variance{};
    for (size_t q = 0; q < 3; ++q)
      if (s.measured[q]) variance[q] = band_variance(s.z[q], 0.3, 0.48, energy);
    // The high band of an acceleration holds the jumps of friction; its noise is what the slower channels do not explain.
    if (s.measured[2] && (s.measured[0] || s.measured[1])) {
      const int other = s.measured[1] ? 1 : 0;
      std::vector<double> power, known;
      for (Eigen::Index i = static_cast<Eigen::Index>(0.5 / f.bin_Hz()); i <= f.last_bin; ++i) {
        const Complex ratio = derivative(f.omega(i), 2) / derivative(f.omega(i), other);
        power.push_back(std::norm(s.z[2][i] - ratio * s.z[static_cast<size_t>(other)][i]) / energy);
        known.push_back(std::norm(ratio) * variance[static_cast<size_t>(other)]);
      }
      variance[2] = std::max(0.02 * variance[2], excess_variance(power, known, 1.2 * variance[2]));
    }
    for (size_t q = 0; q < 3; ++q)
      if (s.measured[q]) s.noise[q] = Series::Constant(s.z[q].size(), std::max(variance[q], 1e-300));
  }
  f.force_noise.assign(f.force.size(), Series());
  for (size_t i = 0; i < f.force.size(); ++i) {
    if (f.force[i].size() == 0) continue;
    const Spectrum z = f.fourier->forward(f.outer.weight.cwiseProduct(f.force[i]));
    f.force_noise[i] = Series::Constant(z.size(), band_variance(z, 0.3, 0.48, energy));
  }
}

}  // namespace diagnosis
