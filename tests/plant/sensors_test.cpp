// Sensors and converters: what they add is what the scenario says, in size and in kind.
#include "host_sim/plant/instruments/sensors.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/plant/scenario_texts.hpp"

namespace {

using host_sim::Quantity;
using plant_test::small_scenario;
using plant_test::spoiled;

host_sim::MeasuredLevels measured(const std::string& sensors, uint64_t seed = 5) {
  return host_sim::measure(host_sim::parse_scenario(spoiled("bits = 24\n", sensors), "small.toml"), seed);
}

std::vector<double> error_of(const host_sim::MeasuredLevels& levels, Quantity quantity,
                             double* rms_of_truth = nullptr) {
  const auto& truth = levels.truth[0].find(quantity, 1)->values;
  const auto& value = levels.measured[0].find(quantity, 1)->values;
  std::vector<double> error;
  double square = 0.0;
  for (size_t k = 1000; k <= 3000; ++k) {  // 1 s of settling, 2 s measured
    error.push_back(value[k] - truth[k]);
    square += truth[k] * truth[k];
  }
  if (rms_of_truth != nullptr) *rms_of_truth = std::sqrt(square / 2001);
  return error;
}

double rms(const std::vector<double>& values) {
  double square = 0.0;
  for (double v : values) square += v * v;
  return std::sqrt(square / static_cast<double>(values.size()));
}

// Rounding to q moves a value by q / 2 at the most, rms q / sqrt 12. Force 20 N * 1.25 in 2^(bits-1) - 1 codes: the
// next power of two is 2^-10 N at 16 bits (25 / 32767 = 7.6e-4 < 9.8e-4), 2^-6 N at 12 bits (25 / 2047 = 0.0122 <
// 0.0156).
TEST(Sensors, CleanChannelsAreOnlyRounded) {
  const int bits[] = {12, 16};
  const double unit[] = {0x1p-6, 0x1p-10};
  for (int i = 0; i < 2; ++i) {
    const auto levels = measured("bits = " + std::to_string(bits[i]) + "\n");
    EXPECT_EQ(levels.calibrations[0].unit_per_code, unit[i]);
    EXPECT_EQ(levels.calibrations[0].highest_code, (1 << (bits[i] - 1)) - 1);
    const auto error = error_of(levels, Quantity::kForce);
    double largest = 0.0;
    for (double e : error) largest = std::max(largest, std::fabs(e));
    EXPECT_LE(largest, 0.5 * unit[i]);
    EXPECT_GT(largest, 0.4 * unit[i]);
  }
}

// 2001 samples: the rms of white noise scatters by 1 / sqrt(4002) = 1.6 %; neighbours' correlation by 1 / sqrt(2001)
// = 2.2 %.
TEST(Sensors, NoiseIsWhiteAndOfTheGivenPercentage) {
  const auto levels = measured("noise_percent = 5.0\n");
  for (Quantity q : {Quantity::kForce, Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration}) {
    double truth = 0.0, neighbours = 0.0;
    const auto error = error_of(levels, q, &truth);
    EXPECT_NEAR(rms(error) / (0.05 * truth), 1.0, 0.08);
    for (size_t k = 1; k < error.size(); ++k) neighbours += error[k] * error[k - 1];
    EXPECT_LT(std::fabs(neighbours / static_cast<double>(error.size()) / (rms(error) * rms(error))), 0.11);
  }
}

// First-order noise of 10 Hz corner at 1 kHz: neighbours correlate by exp(-2 pi 10 / 1000) = 0.939; 2 s hold 2 * pi *
// 10 * 2 = 126 independent values, so rms scatters by about 9 %.
TEST(Sensors, ColouredNoiseRemembers) {
  const auto levels = measured("noise_percent = 5.0\nnoise_corner_Hz = 10.0\n");
  double truth = 0.0, neighbours = 0.0;
  const auto error = error_of(levels, Quantity::kVelocity, &truth);
  EXPECT_NEAR(rms(error) / (0.05 * truth), 1.0, 0.35);
  for (size_t k = 1; k < error.size(); ++k) neighbours += error[k] * error[k - 1];
  EXPECT_NEAR(neighbours / static_cast<double>(error.size()) / (rms(error) * rms(error)), 0.939, 0.03);
}

TEST(Sensors, OffsetAndDriftAreAdded) {
  const auto levels = measured("[[sensors.channel]]\nname = \"velocity_1_m_s\"\noffset = 0.25\ndrift_per_s = -0.125\n");
  const auto error = error_of(levels, Quantity::kVelocity);
  EXPECT_NEAR(error.front(), 0.25, 1e-6);  // t = 0 is the first measured sample
  EXPECT_NEAR(error.back(), 0.0, 1e-6);    // after 2 s
  for (double e : error_of(levels, Quantity::kDisplacement)) EXPECT_NEAR(e, 0.0, 1e-7);
}

// Steady sine of 4 Hz: what was 250 us ago is the cosine 2 pi 4 * 250e-6 rad back; the force is known exactly.
TEST(Sensors, DelayShowsThePast) {
  const auto levels = measured(
      "[[sensors.channel]]\nname = \"force_1_N\"\ndelay_us = 250.0\n[[sensors.channel]]\nname = "
      "\"displacement_1_m\"\ndelay_us = 2000.0\n");
  const auto& force = levels.measured[0].find(Quantity::kForce, 1)->values;
  for (size_t k = 0; k <= 2000; k += 100)
    EXPECT_NEAR(force[1000 + k],
                20.0 * std::cos(2 * 3.14159265358979323846 * 4.0 * (1e-3 * static_cast<double>(k) - 250e-6)), 1e-5);
  const auto& late = levels.measured[0].find(Quantity::kDisplacement, 1)->values;
  const auto& truth = levels.truth[0].find(Quantity::kDisplacement, 1)->values;
  for (size_t k = 1000; k <= 3000; k += 100) EXPECT_NEAR(late[k], truth[k - 2], 1e-8);  // two samples of 1 ms
}

// A full scale of 10 N clips the 20 N force at +-10 N, in code +-32767.
TEST(Sensors, BeyondFullScaleTheConverterClips) {
  const auto levels = measured("bits = 16\n[[sensors.channel]]\nname = \"force_1_N\"\nfull_scale = 10.0\n");
  double largest = 0.0;
  for (double v : levels.measured[0].find(Quantity::kForce, 1)->values) largest = std::max(largest, std::fabs(v));
  EXPECT_NEAR(largest, 10.0, 1e-9);
}

TEST(Sensors, OnlyListedChannelsExist) {
  const auto levels = measured(
      "channels = [\"force\", \"displacement\", \"acceleration\"]\n[[sensors.channel]]\nname = "
      "\"acceleration_1_m_s2\"\npresent = false\n");
  ASSERT_EQ(levels.measured[0].channels.size(), 2u);
  EXPECT_EQ(levels.measured[0].channels[0].name, "force_1_N");
  EXPECT_EQ(levels.measured[0].channels[1].name, "displacement_1_m");
  EXPECT_EQ(levels.calibrations.size(), 2u);
  EXPECT_NE(levels.truth[0].find(Quantity::kAcceleration, 1), nullptr);
}

TEST(Sensors, SameSeedSameBytes) {
  const auto a = measured("noise_percent = 5.0\n", 3), b = measured("noise_percent = 5.0\n", 3),
             c = measured("noise_percent = 5.0\n", 4);
  for (size_t i = 0; i < a.measured[0].channels.size(); ++i) {
    EXPECT_EQ(a.measured[0].channels[i].values, b.measured[0].channels[i].values);
    EXPECT_NE(a.measured[0].channels[i].values, c.measured[0].channels[i].values);
  }
}

// Taking one channel away changes no noise of another.
TEST(Sensors, EachChannelHasItsOwnNoise) {
  const auto all = measured("noise_percent = 5.0\n"),
             two = measured("noise_percent = 5.0\nchannels = [\"force\", \"velocity\"]\n");
  EXPECT_EQ(all.measured[0].find(Quantity::kVelocity, 1)->values, two.measured[0].find(Quantity::kVelocity, 1)->values);
}

}  // namespace
