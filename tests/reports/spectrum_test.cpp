// The spectrum of signals whose power is known.
#include "host_sim/reports/views/spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace {

using namespace host_sim::reports;

std::vector<double> sine(size_t samples, double period_s, double frequency_Hz, double amplitude) {
  std::vector<double> out(samples);
  for (size_t i = 0; i < samples; ++i)
    out[i] = amplitude * std::sin(2 * M_PI * frequency_Hz * static_cast<double>(i) * period_s);
  return out;
}

// A sine of amplitude 3 has the power 4.5. 20000 samples: segments of 4096, bins of 1000/4096 Hz; 31.25 Hz is bin 128.
TEST(Spectrum, ASinesPowerIsInItsPeak) {
  const Spectrum spectrum = power_spectrum(sine(20000, 1e-3, 31.25, 3.0), 1e-3);
  ASSERT_EQ(spectrum.density.size(), 2048u);
  EXPECT_NEAR(spectrum.frequency_Hz[127], 31.25, 1e-9);
  double power = 0.0;
  for (size_t k = 120; k < 136; ++k) power += spectrum.density[k] * 1000.0 / 4096.0;
  EXPECT_NEAR(power, 4.5, 1e-6);
  EXPECT_LT(spectrum.density[400], 1e-12 * spectrum.density[127]);
}

TEST(Spectrum, AConstantHasNone) {
  for (double density : power_spectrum(std::vector<double>(1000, 5.0), 1e-3).density) EXPECT_LT(density, 1e-20);
}

TEST(Spectrum, ARecordTooShortGivesNothing) { EXPECT_TRUE(power_spectrum({1, 2, 3}, 1.0).density.empty()); }

TEST(Spectrum, ReducingKeepsThePeaks) {
  const Spectrum small = reduced({{1, 2, 3, 4, 5, 6}, {0.1, 9.0, 0.2, 0.3, 0.4, 7.0}}, 2);
  EXPECT_EQ(small.frequency_Hz, (std::vector<double>{2, 6}));
  EXPECT_EQ(small.density, (std::vector<double>{9.0, 7.0}));
}

}  // namespace
