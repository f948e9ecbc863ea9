#include "fourier.hpp"

#include <fftw3.h>

#include <mutex>

namespace diagnosis {
namespace {
std::mutex planner;  // FFTW's planner is not safe to share
}

struct Fourier::Plans {
  double* time = nullptr;
  fftw_complex* frequency = nullptr;
  fftw_plan forward = nullptr, inverse = nullptr;
};

Fourier::Fourier(size_t samples) : samples_(samples), plans_(new Plans) {
  const std::lock_guard<std::mutex> lock(planner);
  const int n = static_cast<int>(samples);
  plans_->time = fftw_alloc_real(samples);
  plans_->frequency = fftw_alloc_complex(samples / 2 + 1);
  plans_->forward = fftw_plan_dft_r2c_1d(n, plans_->time, plans_->frequency, FFTW_ESTIMATE);
  plans_->inverse = fftw_plan_dft_c2r_1d(n, plans_->frequency, plans_->time, FFTW_ESTIMATE);
}

Fourier::~Fourier() {
  const std::lock_guard<std::mutex> lock(planner);
  fftw_destroy_plan(plans_->forward);
  fftw_destroy_plan(plans_->inverse);
  fftw_free(plans_->time);
  fftw_free(plans_->frequency);
}

Spectrum Fourier::forward(const Series& series) const { return forward(series, bins()); }

Spectrum Fourier::forward(const Series& series, Eigen::Index count) const {
  Series::Map(plans_->time, series.size()) = series;
  fftw_execute(plans_->forward);
  return Spectrum::Map(reinterpret_cast<Complex*>(plans_->frequency), count);
}

Series Fourier::inverse(const Spectrum& spectrum) const {
  Spectrum::Map(reinterpret_cast<Complex*>(plans_->frequency), bins()) = spectrum;
  fftw_execute(plans_->inverse);
  return Series::Map(plans_->time, static_cast<Eigen::Index>(samples_)) / static_cast<double>(samples_);
}

double power(const Eigen::Ref<const Spectrum>& s, bool from_mean) {
  return 2 * s.squaredNorm() - (from_mean ? std::norm(s[0]) : 0);
}

double mean_square(const Spectrum& s, double window_energy, Eigen::Index first) {
  return power(s.tail(s.size() - first), first == 0) / (window_energy * static_cast<double>(2 * (s.size() - 1)));
}

size_t fast_length(size_t samples) {
  for (size_t n = samples; n > 1; --n) {
    size_t rest = n;
    for (size_t prime : {2, 3, 5, 7})
      while (rest % prime == 0) rest /= prime;
    if (rest == 1) return n;
  }
  return samples;
}

Ramp make_ramp(size_t samples, double period_s, double start_s, double ramp_s) {
  const Eigen::Index n = static_cast<Eigen::Index>(samples);
  Ramp r{Series::Zero(n), Series::Zero(n), Series::Zero(n)};
  const double last_s = static_cast<double>(samples - 1) * period_s;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) * period_s;
    const bool falling = t > 0.5 * last_s;
    const double p = ((falling ? last_s - t : t) - start_s) / ramp_s;
    if (p <= 0) continue;
    if (p >= 1) {
      r.weight[i] = 1;
      continue;
    }
    // 35 p^4 - 84 p^5 + 70 p^6 - 20 p^7
    r.weight[i] = p * p * p * p * (35 + p * (-84 + p * (70 - 20 * p)));
    r.slope[i] = p * p * p * (140 + p * (-420 + p * (420 - 140 * p))) / ramp_s * (falling ? -1 : 1);
    r.bend[i] = p * p * (420 + p * (-1680 + p * (2100 - 840 * p))) / (ramp_s * ramp_s);
  }
  return r;
}

}  // namespace diagnosis
