#include "host_sim/data_check/spectrum.hpp"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

namespace host_sim::data_check {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr size_t kMostSamples = 1 << 18;

}  // namespace

size_t quick_length(size_t samples) {
  for (size_t n = std::min(samples, kMostSamples);; --n) {
    size_t left = n;
    for (const size_t factor : {2, 3, 5, 7})
      while (left % factor == 0) left /= factor;
    if (left == 1) return n;
  }
}

std::vector<double> power_spectrum(const double* from, size_t n, double mean) {
  const std::unique_ptr<double, void (*)(void*)> input(fftw_alloc_real(n), fftw_free);
  const std::unique_ptr<fftw_complex, void (*)(void*)> output(fftw_alloc_complex(n / 2 + 1), fftw_free);
  for (size_t i = 0; i < n; ++i)
    input.get()[i] =
        (from[i] - mean) * (0.5 - 0.5 * std::cos(2.0 * kPi * static_cast<double>(i) / static_cast<double>(n)));
  static std::once_flag shared;  // records are checked beside each other
  std::call_once(shared, fftw_make_planner_thread_safe);
  const fftw_plan plan = fftw_plan_dft_r2c_1d(static_cast<int>(n), input.get(), output.get(), FFTW_ESTIMATE);
  fftw_execute(plan);
  fftw_destroy_plan(plan);
  std::vector<double> power(n / 2 + 1);
  for (size_t i = 0; i < power.size(); ++i)
    power[i] = output.get()[i][0] * output.get()[i][0] + output.get()[i][1] * output.get()[i][1];
  return power;
}

}  // namespace host_sim::data_check
