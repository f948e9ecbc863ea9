// The noise of a channel is read beside a motion: white, coloured, different from record to record, or not to be told from it.
#include "hal/rig_file/recorded/channel_noise.hpp"

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
  return rig_file::read_noise(rig_file::codes_of(records, 0, static_cast<int>(quantity)), static_cast<int>(quantity),
                              kRate_Hz);
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

// A level motion up to a tenth of the sample rate, 100 times the noise: its power at the top of the spectrum of four differences is
// several times the noise's. A velocity that is integrated or an acceleration took that for noise, and right rigs were accused.
TEST(ChannelNoise, WhiteNoiseBesideAMotionOfTenSamplesAPeriod) {
  std::mt19937 random(10);
  std::uniform_real_distribution<double> phase(0.0, 2 * M_PI);
  std::vector<double> motion(20000, 0.0);
  for (int line = 1; line <= 100; ++line) {
    const double start = phase(random), step = 2 * M_PI * line / kRate_Hz;
    for (size_t n = 0; n < motion.size(); ++n) motion[n] += 1.41e5 * std::sin(step * static_cast<double>(n) + start);
  }
  for (const Quantity quantity :
       {Quantity::kForce, Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration}) {
    auto samples = record(quantity, 0.0, 1e4, 0.0, 11);
    for (size_t n = 0; n < samples.size(); ++n)
      samples[n].code[0][static_cast<int>(quantity)] += static_cast<int32_t>(std::lround(motion[n]));
    const auto noise = read({samples}, quantity);
    EXPECT_NEAR(noise.deviation, 1e4, 500.0);
    EXPECT_EQ(noise.pole, 0.0);
    EXPECT_LT(noise.doubt, 0.1);
  }
}

// Kinks of friction reach every band at the top, and four seconds hold but four periods of the slowest motion: forty show what is below.
TEST(ChannelNoise, BelowASlowMotionThatFillsTheRest) {
  std::mt19937 random(12);
  std::normal_distribution<double> normal;
  auto samples = record(Quantity::kVelocity, 0.0, 1e4, 0.0, 13);
  for (size_t n = 0; n < samples.size(); ++n) {
    const double turns = static_cast<double>(n) / 64 + 0.02 * std::sin(0.001 * static_cast<double>(n));
    samples[n].code[0][static_cast<int>(Quantity::kVelocity)] +=
        static_cast<int32_t>(std::lround(4e6 * std::fabs(turns - std::floor(turns) - 0.5)));
  }
  const auto noise = rig_file::read_noise(rig_file::codes_of({samples}, 0, static_cast<int>(Quantity::kVelocity)),
                                          static_cast<int>(Quantity::kVelocity), 64.0);
  EXPECT_NEAR(noise.deviation, 1e4, 4e3);
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

// One pole pair of a low-pass by the bilinear transform, corner 0.22 per sample.
std::vector<double> passed(const std::vector<double>& in, double quality) {
  const double w = std::tan(M_PI * 0.22), a0 = 1 + w / quality + w * w;
  std::vector<double> out(in.size());
  for (size_t n = 2; n < in.size(); ++n)
    out[n] = (w * w * (in[n] + 2 * in[n - 1] + in[n - 2]) - 2 * (w * w - 1) * out[n - 1] -
              (1 - w / quality + w * w) * out[n - 2]) /
             a0;
  return out;
}
// Fourth order, Butterworth.
std::vector<double> behind_filter(const std::vector<double>& in) { return passed(passed(in, 0.5412), 1.3066); }

std::vector<firmware::RawSample> displacement(const std::vector<double>& values) {
  std::vector<firmware::RawSample> samples(values.size());
  for (size_t n = 0; n < values.size(); ++n)
    samples[n].code[0][static_cast<int>(Quantity::kDisplacement)] = static_cast<int32_t>(std::lround(values[n]));
  return samples;
}

// White noise of 2e4 codes through a filter of impulse response h: autocovariance 4e8 sum of h[n] h[n + lag].
TEST(ChannelNoise, NoiseBehindAnAntiAliasFilterHasTheFiltersCorrelation) {
  std::mt19937 random(8);
  std::normal_distribution<double> normal(0.0, 2e4);
  std::vector<double> noise_in(20000), impulse(64, 0.0);
  for (double& value : noise_in) value = normal(random);
  impulse[2] = 1;
  const std::vector<double> h = behind_filter(impulse);
  std::vector<double> values = behind_filter(noise_in);
  for (size_t n = 0; n < values.size(); ++n)
    values[n] += 1e6 * std::sin(2 * M_PI * 10.0 * static_cast<double>(n) / kRate_Hz);
  double covariance[4] = {};
  for (size_t lag = 0; lag < 4; ++lag)
    for (size_t n = 0; n + lag < h.size(); ++n) covariance[lag] += 4e8 * h[n] * h[n + lag];
  const auto noise = read({displacement(values)}, Quantity::kDisplacement);
  EXPECT_FALSE(noise.white());
  EXPECT_NEAR(noise.deviation * noise.deviation, covariance[0], 0.1 * covariance[0]);
  for (size_t lag = 0; lag < 4; ++lag) EXPECT_NEAR(noise.correlated(lag), covariance[lag] / covariance[0], 0.03) << lag;
  EXPECT_LT(noise.doubt, 0.45);
}

// The same spectrum, but a motion's: level up to a corner, with white noise of 1 % below it.
TEST(ChannelNoise, AMotionUpToACornerIsNoNoise) {
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  std::vector<double> motion(20000);
  for (double& value : motion) value = 1e6 * normal(random);
  motion = behind_filter(motion);
  for (double& value : motion) value += 1e4 * normal(random);
  EXPECT_TRUE(read({displacement(motion)}, Quantity::kDisplacement).correlation.empty());
}

// At 0.35 of the sample rate a motion stands in every band that noise is read in.
TEST(ChannelNoise, AMotionThatFillsTheBandLeavesABound) {
  const auto noise = read({record(Quantity::kDisplacement, 350.0, 1e4, 0.0, 4)}, Quantity::kDisplacement);
  EXPECT_GE(noise.doubt, 1.0);
  EXPECT_GT(noise.deviation, 1e4);
  EXPECT_TRUE(noise.correlation.empty());
}

// 1e4 codes in one record and twice that in the other: 2.5 times the mean square of the first, so off by 60 % in each.
TEST(ChannelNoise, NoiseThatDiffersBetweenRecordsIsInDoubt) {
  const auto noise =
      read({record(Quantity::kDisplacement, 10.0, 1e4, 0.0, 5), record(Quantity::kDisplacement, 10.0, 2e4, 0.0, 6)},
           Quantity::kDisplacement);
  EXPECT_NEAR(noise.doubt, 0.6, 0.06);
  EXPECT_NEAR(noise.deviation, 1e4 * std::sqrt(2.5), 500.0);
}

// The rounding of a code is even over +-1/2: a deviation of 1 / sqrt(12). That nothing changes says that there is no more.
TEST(ChannelNoise, ASilentChannelHasThatOfItsRounding) {
  for (const Quantity quantity : {Quantity::kForce, Quantity::kDisplacement})
    EXPECT_NEAR(read({record(quantity, 0.0, 0.0, 0.0, 7)}, quantity).deviation, 1 / std::sqrt(12.0), 1e-4);
}

TEST(ChannelNoise, BlowsBetweenSilenceAreNoNoise) {
  auto blows = record(Quantity::kForce, 0.0, 0.0, 0.0, 8);
  for (size_t n = 100; n < blows.size(); n += 500) blows[n].code[0][static_cast<int>(Quantity::kForce)] = 1000000;
  EXPECT_NEAR(read({blows}, Quantity::kForce).deviation, 1 / std::sqrt(12.0), 1e-4);
}

TEST(ChannelNoise, WithoutARecordItIsNotKnown) { EXPECT_EQ(read({}, Quantity::kForce).deviation, 0.0); }

// A tone of 2^20 codes at a twentieth of the sample rate, whose differences of order 8 have (2 sin(pi / 20))^8 = 9.2e-5 of it, over
// sqrt(12870) = 113 8e-7; noise of 10 codes is 1.3e-5 of its rms, of 2 codes 2.7e-6.
TEST(ChannelNoise, OfAHundredThousandthMovesNothing) {
  for (const double deviation : {0.0, 2.0, 10.0}) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    rig_file::ChannelCodes codes(1);
    for (int i = 0; i < 20000; ++i)
      codes[0].push_back(static_cast<int32_t>(
          std::lround(std::ldexp(1.0, 20) * std::sin(0.1 * 3.14159265358979 * i) + deviation * normal(random))));
    EXPECT_EQ(rig_file::hardly_noisy(codes), deviation < 5.0) << deviation;
  }
}

}  // namespace
