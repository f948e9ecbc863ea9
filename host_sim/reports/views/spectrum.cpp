#include "host_sim/reports/views/spectrum.hpp"

#include <fftw3.h>

#include <cmath>

namespace host_sim::reports {
namespace {

// FFTW of real segments of one length. Its planner is not safe to share between threads; reports are written by one.
class RealTransform {
 public:
  explicit RealTransform(size_t length)
      : time_(fftw_alloc_real(length)),
        bins_(fftw_alloc_complex(length / 2 + 1)),
        plan_(fftw_plan_dft_r2c_1d(static_cast<int>(length), time_, bins_, FFTW_ESTIMATE)) {}
  RealTransform(const RealTransform&) = delete;
  RealTransform& operator=(const RealTransform&) = delete;
  ~RealTransform() {
    fftw_destroy_plan(plan_);
    fftw_free(bins_);
    fftw_free(time_);
  }
  double* segment() { return time_; }
  void execute() { fftw_execute(plan_); }
  double power(size_t bin) const { return bins_[bin][0] * bins_[bin][0] + bins_[bin][1] * bins_[bin][1]; }

 private:
  double* time_;
  fftw_complex* bins_;
  fftw_plan plan_;
};

}  // namespace

Spectrum power_spectrum(const std::vector<double>& values, double sample_period_s) {
  size_t length = 4096;
  while (length > 64 && values.size() < 4 * length + length / 2)
    length /= 2;  // 8 segments at half overlap: 4.5 lengths
  Spectrum spectrum;
  if (values.size() < length) return spectrum;
  const double n = static_cast<double>(length);
  std::vector<double> window(length), power(length / 2 + 1, 0.0);
  double window_power = 0.0;
  for (size_t i = 0; i < length; ++i) {
    window[i] = 0.5 - 0.5 * std::cos(2.0 * M_PI * static_cast<double>(i) / n);
    window_power += window[i] * window[i];
  }
  RealTransform transform(length);
  size_t segments = 0;
  for (size_t first = 0; first + length <= values.size(); first += length / 2, ++segments) {
    double mean = 0.0;
    for (size_t i = 0; i < length; ++i) mean += values[first + i] / n;
    for (size_t i = 0; i < length; ++i) transform.segment()[i] = (values[first + i] - mean) * window[i];
    transform.execute();
    for (size_t k = 0; k <= length / 2; ++k) power[k] += transform.power(k);
  }
  for (size_t k = 1; k <= length / 2; ++k) {
    const double sides = k == length / 2 ? 1.0 : 2.0;
    spectrum.frequency_Hz.push_back(static_cast<double>(k) / (n * sample_period_s));
    spectrum.density.push_back(sides * power[k] * sample_period_s / (window_power * static_cast<double>(segments)));
  }
  return spectrum;
}

Spectrum reduced(const Spectrum& spectrum, size_t points) {
  const size_t count = spectrum.density.size();
  if (count <= points) return spectrum;
  Spectrum out;
  for (size_t p = 0; p < points; ++p) {
    size_t peak = p * count / points;
    for (size_t k = peak; k < (p + 1) * count / points; ++k)
      if (spectrum.density[k] > spectrum.density[peak]) peak = k;
    out.frequency_Hz.push_back(spectrum.frequency_Hz[peak]);
    out.density.push_back(spectrum.density[peak]);
  }
  return out;
}

}  // namespace host_sim::reports
