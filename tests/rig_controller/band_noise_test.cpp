// Band-limited noise: rms, band, determinism.
#include "firmware/excitation/band_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

namespace {

constexpr double kFullScale = 2147483648.0;
constexpr double kSampleRate_Hz = 1000.0;

uint32_t step_of(double frequency_Hz) { return static_cast<uint32_t>(frequency_Hz / kSampleRate_Hz * 4294967296.0); }

std::vector<double> record(uint32_t seed, int samples, double rms) {
  firmware::BandNoise noise;
  noise.begin(step_of(5.0), step_of(50.0), seed);
  std::vector<double> values;
  const auto level = firmware::Drive::from_raw(static_cast<int32_t>(rms * kFullScale));
  for (int i = 0; i < samples; ++i) values.push_back(static_cast<double>(noise.next(level)) / kFullScale);
  return values;
}

double rms_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

// Power within [low, high) Hz by direct projection on a fine grid, Hann-weighted.
double band_power(const std::vector<double>& values, double low_Hz, double high_Hz) {
  const double n = static_cast<double>(values.size());
  double power = 0.0;
  for (double f = low_Hz; f < high_Hz; f += kSampleRate_Hz / n) {
    std::complex<double> sum = 0.0;
    for (size_t i = 0; i < values.size(); ++i) {
      const double t = static_cast<double>(i);
      sum += values[i] * (1.0 - std::cos(2.0 * M_PI * t / n)) * std::polar(1.0, -2.0 * M_PI * f * t / kSampleRate_Hz);
    }
    power += std::norm(sum);
  }
  return power;
}

TEST(BandNoise, RmsIsAsAsked) {
  // 64 lines over 60 s: neighbouring lines beat at 0.7 Hz and slower, so the rms of one record wanders by a few
  // percent.
  for (uint32_t seed = 1; seed <= 20; ++seed) EXPECT_NEAR(rms_of(record(seed, 60000, 0.1)), 0.1, 0.004) << seed;
}

TEST(BandNoise, StaysInItsBand) {
  const std::vector<double> values = record(7, 4000, 0.1);
  const double inside = band_power(values, 4.0, 51.0);
  const double outside = band_power(values, 0.0, 4.0) + band_power(values, 51.0, 120.0);
  EXPECT_GT(inside, 0.0);
  EXPECT_LT(outside / inside, 1e-3);
}

TEST(BandNoise, EveryTenthOfTheBandHasItsShare) {
  const std::vector<double> values = record(11, 8000, 0.1);
  const double whole = band_power(values, 5.0, 50.0);
  for (int tenth = 0; tenth < 10; ++tenth) {
    const double low = 5.0 + 4.5 * tenth;
    EXPECT_NEAR(band_power(values, low, low + 4.5) / whole, 0.1, 0.06) << low;
  }
}

TEST(BandNoise, SameSeedSameBytesOtherSeedOtherSignal) {
  EXPECT_EQ(record(3, 500, 0.2), record(3, 500, 0.2));
  EXPECT_NE(record(3, 500, 0.2), record(4, 500, 0.2));
}

TEST(BandNoise, FullScaleRmsDoesNotOverflow) {
  firmware::BandNoise noise;
  noise.begin(step_of(5.0), step_of(50.0), 5);
  double largest = 0.0;
  for (int i = 0; i < 20000; ++i) {
    largest = std::max(largest, std::fabs(static_cast<double>(noise.next(firmware::Drive::from_raw(INT32_MAX)))));
  }
  EXPECT_LT(largest / kFullScale, 64 * 0.1768);  // all lines in phase: sqrt(2 * 64) = 11.3 times the rms
  EXPECT_GT(largest / kFullScale, 2.0);
}

}  // namespace
