// Discrete Fourier transform of one length (FFTW), and the smooth ramps that make a record periodic.
#pragma once
#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <memory>

namespace diagnosis {

constexpr double kTwoPi = 6.283185307179586;
// Of a channel's rms: to that no two sensors agree, nor a simulation's samples with its motion.
constexpr double kFinest = 1e-4;
constexpr double kMedianOfSpread = 0.6931471805599453;  // of an exponential law, as the power of noise has it, per mean

using Complex = std::complex<double>;
using Series = Eigen::VectorXd;     // one value per sample
using Spectrum = Eigen::VectorXcd;  // bins 0 .. N/2

class Fourier {
 public:
  explicit Fourier(size_t samples);
  ~Fourier();
  Fourier(const Fourier&) = delete;
  Fourier& operator=(const Fourier&) = delete;
  size_t samples() const { return samples_; }
  Eigen::Index bins() const { return static_cast<Eigen::Index>(samples_ / 2 + 1); }
  Spectrum forward(const Series& series) const;                     // sum of s[i] exp(-j 2 pi k i / N)
  Spectrum forward(const Series& series, Eigen::Index bins) const;  // the first bins only
  Series inverse(const Spectrum& spectrum) const;                   // forward() undone
 private:
  size_t samples_;
  struct Plans;
  std::unique_ptr<Plans> plans_;
};

// Sum of squares over positive and negative frequencies. Every bin stands for two of them but the mean, where the first bin
// is the mean.
double power(const Eigen::Ref<const Spectrum>& spectrum, bool from_mean);

// Mean square of a series that has this spectrum under a window of this energy (the sum of its squares), from a bin on.
double mean_square(const Spectrum& spectrum, double window_energy, Eigen::Index first_bin = 0);

// The largest length up to `samples` whose prime factors are 2, 3, 5 and 7.
size_t fast_length(size_t samples);

// A weight over time that rises from 0 to 1 in [start, start + ramp) and falls likewise at the end, with its first and
// second derivative in time (1/s, 1/s^2). Three continuous derivatives.
struct Ramp {
  Series weight, slope, bend;
};
Ramp make_ramp(size_t samples, double period_s, double start_s, double ramp_s);

}  // namespace diagnosis
