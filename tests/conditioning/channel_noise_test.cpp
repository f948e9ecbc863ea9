// The noise of a channel is read beside a motion: white, coloured, different from record to record, or not to be told from it.
#include "hal/rig_file/channel_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using firmware::Quantity;
using Records = std::vector<std::vector<firmware::RawSample>>;

constexpr double kRate_Hz = 1000.0;

// A sine of 1e6 codes beside first-order noise of 1e4 codes, 20 s.
std::vector<firmware::RawSample> record(Quantity quantity, double motion_Hz, double deviation, double pole,
                                        unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<firmware::RawSample> samples(20000);
  double noise = normal(random);
  for (size_t n = 0; n < samples.size(); ++n) {
    const double motion = 1e6 * std::sin(2 * M_PI * motion_Hz * static_cast<double>(n) / kRate_Hz);
    samples[n].code[0][static_cast<int>(quantity)] = static_cast<int32_t>(std::lround(motion + deviation * noise));
    noise = pole * noise + std::sqrt(1 - pole * pole) * normal(random);
  }
  return samples;
}

rig_file::ChannelNoise read(const Records& records, Quantity quantity) {
  return rig_file::read_noise(records, 0, static_cast<int>(quantity), kRate_Hz);
}

TEST(ChannelNoise, WhiteNoiseBesideASlowMotion) {
  for (const Quantity quantity :
       {Quantity::kForce, Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration}) {
    const auto noise = read({record(quantity, 10.0, 1e4, 0.0, 1)}, quantity);
    EXPECT_NEAR(noise.deviation, 1e4, 300.0);  // three deviations of a level from 20000 samples
    EXPECT_EQ(noise.pole, 0.0);
    EXPECT_LT(noise.doubt, 0.1);
  }
}

TEST(ChannelNoise, ColouredNoiseOfADisplacement) {
  const auto noise = read({record(Quantity::kDisplacement, 10.0, 1e4, 0.5, 2)}, Quantity::kDisplacement);
  EXPECT_NEAR(noise.pole, 0.5, 0.1);
  EXPECT_NEAR(noise.deviation, 1e4, 1e3);
  EXPECT_GT(noise.doubt, 0.1);
}

// 20 records' segments of four seconds show the bottom of the spectrum below a motion at 20 Hz.
TEST(ChannelNoise, ColouredNoiseOfAnAccelerationIsReadBelowTheMotion) {
  const auto noise = read({record(Quantity::kAcceleration, 20.0, 1e4, 0.8, 3)}, Quantity::kAcceleration);
  EXPECT_NEAR(noise.pole, 0.8, 0.1);
  EXPECT_NEAR(noise.deviation, 1e4, 3e3);
}

// At 0.35 of the sample rate a motion stands in every band that noise is read in.
TEST(ChannelNoise, AMotionThatFillsTheBandLeavesABound) {
  const auto noise = read({record(Quantity::kDisplacement, 350.0, 1e4, 0.0, 4)}, Quantity::kDisplacement);
  EXPECT_GE(noise.doubt, 1.0);
  EXPECT_GT(noise.deviation, 1e4);
}

// 1e4 codes in one record and twice that in the other: 2.5 times the mean square of the first, so off by 60 % in each.
TEST(ChannelNoise, NoiseThatDiffersBetweenRecordsIsInDoubt) {
  const auto noise =
      read({record(Quantity::kDisplacement, 10.0, 1e4, 0.0, 5), record(Quantity::kDisplacement, 10.0, 2e4, 0.0, 6)},
           Quantity::kDisplacement);
  EXPECT_NEAR(noise.doubt, 0.6, 0.06);
  EXPECT_NEAR(noise.deviation, 1e4 * std::sqrt(2.5), 500.0);
}

TEST(ChannelNoise, ASilentChannelHasNone) {
  EXPECT_EQ(read({record(Quantity::kDisplacement, 0.0, 0.0, 0.0, 7)}, Quantity::kDisplacement).deviation, 0.0);
}

}  // namespace
