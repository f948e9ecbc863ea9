#include "host_sim/programs/shared/slow_part.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "host_sim/data_check/measures/spectrum.hpp"

namespace host_sim {
namespace {

constexpr double kDriven = 4.0;        // times the noise, of a mean over nine bins
constexpr double kLeastOfPeak = 1e-6;  // of the strongest bin: less is what the window leaves of it
constexpr double kMostBelow = 0.01;    // of the channel's power: a drift of a tenth of its rms
constexpr size_t kHalfMean = 4;        // bins on either side
constexpr size_t kOfMean = 2;          // bins that a start from rest leaves of the mean under the window
constexpr double kStandsOut = 12.0;    // times the level, of one bin: chance in exp(-12)
constexpr double kMedian = 0.6931;     // of a power of white noise, over its mean
constexpr size_t kFewestBins = 16, kFewestOfLevel = 8;  // below the drive: fewer tell no level
constexpr size_t kFewestOfMeasured = 8,
                 kFewestOfItsLevel = 6;  // of a displacement, whose drift has to be a tenth of it besides
constexpr double kNothingLeft = 1e-4;    // of its power: what a smooth drift has higher up is a hundredth of the rms

struct Spectrum {
  std::vector<double> power;
  double bin_Hz = 0.0;
};

Spectrum spectrum_of(const std::vector<double>& values, double sample_period_s) {
  const size_t length = data_check::quick_length(values.size());
  const double mean =
      std::accumulate(values.begin(), values.begin() + static_cast<long>(length), 0.0) / static_cast<double>(length);
  return {data_check::power_spectrum(values.data(), length, mean),
          1.0 / (static_cast<double>(length) * sample_period_s)};
}

}  // namespace

double lowest_drive_Hz(const std::vector<double>& values, double sample_period_s) {
  const Spectrum s = spectrum_of(values, sample_period_s);
  const size_t bins = s.power.size();
  if (bins < 8 * kHalfMean) return 0.0;
  const double noise = data_check::median_power(s.power, 3 * bins / 4, bins) / kMedian;
  const double least = std::max(kDriven * noise, kLeastOfPeak * *std::max_element(s.power.begin() + 1, s.power.end()));
  const auto drives_at = [&](size_t k) {
    const double sum = std::accumulate(s.power.begin() + static_cast<long>(k - kHalfMean),
                                       s.power.begin() + static_cast<long>(k + kHalfMean + 1), 0.0);
    return sum > least * (2.0 * kHalfMean + 1.0);
  };
  double whole = 0.0, below = 0.0;
  for (size_t k = 1; k < bins; ++k) whole += std::max(0.0, s.power[k] - noise);
  size_t k = 1;
  for (; k < bins && below <= kMostBelow * whole; ++k) below += std::max(0.0, s.power[k] - noise);
  if (k + kHalfMean >= bins) return 0.0;
  while (k > 1 + kHalfMean && drives_at(k)) --k;
  return k <= 1 + 2 * kHalfMean ? 0.0 : static_cast<double>(k) * s.bin_Hz;
}

double drift_end_Hz(const std::vector<double>& values, double sample_period_s, double lowest_Hz, int integrations,
                    double least_share) {
  const Spectrum s = spectrum_of(values, sample_period_s);
  const size_t half = static_cast<size_t>(0.5 * lowest_Hz / s.bin_Hz),
               most = std::min(static_cast<size_t>(0.9 * lowest_Hz / s.bin_Hz), s.power.size());
  const bool measured = integrations == 0 && least_share > 0.0;
  if (half < (measured ? kFewestOfMeasured : kFewestBins) ||
      most < half + (measured ? kFewestOfItsLevel : kFewestOfLevel))
    return 0.0;
  const double level = data_check::median_power(s.power, half, most);
  size_t end = half;
  while (end > kOfMean && s.power[end] <= kStandsOut * level / kMedian) --end;
  if (end <= kOfMean) return 0.0;
  double slow = 0.0, motion = 0.0;  // of the integral
  for (size_t k = 1; k < s.power.size(); ++k)
    (k <= end ? slow : motion) += s.power[k] * std::pow(static_cast<double>(k), -2.0 * integrations);
  if (slow < least_share * motion) return 0.0;
  for (double left = 0.0; measured && end > 1; --end)
    if ((left += s.power[end]) > kNothingLeft * motion) break;
  return static_cast<double>(end + 1) * s.bin_Hz;
}

void take_off_cosines(std::vector<double>& values, double sample_period_s, double end_Hz) {
  const double n = static_cast<double>(values.size());
  const size_t count = static_cast<size_t>(2.0 * end_Hz * n * sample_period_s);
  std::vector<double> cosine(values.size());
  for (size_t k = 1; k <= count; ++k) {
    double sum = 0.0;
    for (size_t i = 0; i < values.size(); ++i) {
      cosine[i] = std::cos(M_PI * static_cast<double>(k) * (static_cast<double>(i) + 0.5) / n);
      sum += cosine[i] * values[i];
    }
    for (size_t i = 0; i < values.size(); ++i) values[i] -= 2.0 / n * sum * cosine[i];
  }
}

}  // namespace host_sim
