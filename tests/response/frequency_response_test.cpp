// Responses of pairs whose answer is known.
#include "host_sim/response/frequency_response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace host_sim;

namespace {

std::vector<double> white(size_t count, uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> out(count);
  for (double& value : out) value = normal(random);
  return out;
}

}  // namespace

TEST(FrequencyResponse, SegmentsFitTheRecord) {
  EXPECT_EQ(response_segment(100000), 8192u);
  EXPECT_EQ(response_segment(4608), 1024u);  // 4.5 times 1024
  EXPECT_EQ(response_segment(4607), 512u);
  EXPECT_EQ(response_segment(64), 64u);
  EXPECT_EQ(response_segment(63), 0u);
}

// Twice the input two samples later: 2 exp(-2 i omega T) at every frequency, coherence near 1 (the window's ends differ).
TEST(FrequencyResponse, AGainAndADelay) {
  const std::vector<double> x = white(20000, 1);
  std::vector<double> y(x.size(), 0.0);
  for (size_t i = 2; i < x.size(); ++i) y[i] = 2.0 * x[i - 2];
  const FrequencyResponse response = frequency_response({{&x, &y}}, 1e-3, 256);
  ASSERT_EQ(response.frequency_Hz.size(), 128u);
  EXPECT_NEAR(response.frequency_Hz[0], 1000.0 / 256, 1e-9);
  for (size_t k = 4; k < 120; ++k) {
    const std::complex<double> exact =
        2.0 * std::exp(std::complex<double>(0.0, -2.0 * 2.0 * M_PI * response.frequency_Hz[k] * 1e-3));
    EXPECT_LT(std::abs(response.response[k] - exact), 0.06);
    EXPECT_GT(response.coherence[k], 0.995);
  }
}

// Signal and independent noise of the same power: coherence 1/2. Each bin of some 300 half-overlapping segments scatters
// by about sqrt(2 (1 - 1/2)^2 (1/2) / 160) = 0.04; the mean over 120 bins by 0.004.
TEST(FrequencyResponse, NoiseHalvesTheCoherence) {
  const std::vector<double> x = white(40000, 2), noise = white(40000, 3);
  std::vector<double> y(x.size());
  for (size_t i = 0; i < x.size(); ++i) y[i] = x[i] + noise[i];
  const FrequencyResponse response = frequency_response({{&x, &y}}, 1e-3, 256);
  double mean = 0.0;
  for (size_t k = 0; k < 127; ++k) mean += response.coherence[k] / 127.0;
  EXPECT_NEAR(mean, 0.5, 0.02);
}

TEST(FrequencyResponse, AveragesRunOverAllRecords) {
  const std::vector<double> x = white(1000, 4), y = white(700, 5), z = white(700, 6);
  EXPECT_EQ(frequency_response({{&x, &x}, {&y, &z}}, 1e-3, 256).segments, 6u + 4u);  // 1000: 6.8 halves, 700: 4.4
}

TEST(FrequencyResponse, ADeadInputGivesNoNumbersThatAreNone) {
  const std::vector<double> x(600, 0.0), y = white(600, 7);
  const FrequencyResponse response = frequency_response({{&x, &y}}, 1e-3, 256);
  for (size_t k = 0; k < response.coherence.size(); ++k) {
    EXPECT_EQ(response.coherence[k], 0.0);
    EXPECT_EQ(std::abs(response.response[k]), 0.0);
  }
}
