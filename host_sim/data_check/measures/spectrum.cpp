#include "host_sim/data_check/measures/spectrum.hpp"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <mutex>

#include "host_sim/records/median.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr size_t kMostSamples = 1 << 18;
constexpr size_t kKept = 4;  // lengths: those of the records' parts and of two records that differ

// How n values are transformed, and a Hann window over them. To plan takes longer than to transform.
struct Transform {
  explicit Transform(size_t n) : window(n) {
    for (size_t i = 0; i < n; ++i)
      window[i] = 0.5 - 0.5 * std::cos(2.0 * kPi * static_cast<double>(i) / static_cast<double>(n));
    // Any memory of theirs is aligned like any other: the plan holds for all.
    const std::unique_ptr<double, void (*)(void*)> input(fftw_alloc_real(n), fftw_free);
    const std::unique_ptr<fftw_complex, void (*)(void*)> output(fftw_alloc_complex(n / 2 + 1), fftw_free);
    plan = fftw_plan_dft_r2c_1d(static_cast<int>(n), input.get(), output.get(), FFTW_ESTIMATE);
  }
  ~Transform() { fftw_destroy_plan(plan); }
  Transform(const Transform&) = delete;
  Transform& operator=(const Transform&) = delete;

  std::vector<double> window;
  fftw_plan plan = nullptr;
};

// The last few that were asked for; records are checked beside each other.
std::shared_ptr<const Transform> transform_of(size_t n) {
  static std::mutex mutex;
  static std::deque<std::shared_ptr<const Transform>> kept;
  const std::lock_guard<std::mutex> lock(mutex);
  for (const auto& transform : kept)
    if (transform->window.size() == n) return transform;
  static std::once_flag shared;  // others plan too
  std::call_once(shared, fftw_make_planner_thread_safe);
  kept.push_back(std::make_shared<const Transform>(n));
  if (kept.size() > kKept) kept.pop_front();
  return kept.back();
}

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
  const std::shared_ptr<const Transform> transform = transform_of(n);
  const std::unique_ptr<double, void (*)(void*)> input(fftw_alloc_real(n), fftw_free);
  const std::unique_ptr<fftw_complex, void (*)(void*)> output(fftw_alloc_complex(n / 2 + 1), fftw_free);
  for (size_t i = 0; i < n; ++i) input.get()[i] = (from[i] - mean) * transform->window[i];
  fftw_execute_dft_r2c(transform->plan, input.get(), output.get());
  std::vector<double> power(n / 2 + 1);
  for (size_t i = 0; i < power.size(); ++i)
    power[i] = output.get()[i][0] * output.get()[i][0] + output.get()[i][1] * output.get()[i][1];
  return power;
}

double median_power(const std::vector<double>& power, size_t first, size_t last) {
  return median({power.begin() + static_cast<long>(first), power.begin() + static_cast<long>(last)});
}

}  // namespace host_sim::data_check
