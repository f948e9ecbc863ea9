#include "host_sim/plant/instruments/signal.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/plant/instruments/random_numbers.hpp"

namespace {

constexpr double kTwoPi = 6.28318530717958647692;

// mt19937_64 from seed 5489 is fixed by the standard (its 10000th output is 9981545732273789042): the generator below
// us is it.
TEST(RandomNumbers, TheGeneratorIsTheStandards) {
  std::mt19937_64 generator;
  generator.discard(9999);
  EXPECT_EQ(generator(), 9981545732273789042ULL);
}

TEST(RandomNumbers, NormalHasItsMoments) {
  host_sim::RandomNumbers random(7, 3);
  double sum = 0, square = 0, fourth = 0;
  const int n = 200000;
  for (int i = 0; i < n; ++i) {
    const double z = random.normal();
    sum += z;
    square += z * z;
    fourth += z * z * z * z;
  }
  EXPECT_NEAR(sum / n, 0.0, 5.0 / std::sqrt(n));            // std of a mean: 1 / sqrt n
  EXPECT_NEAR(square / n, 1.0, 5.0 * std::sqrt(2.0 / n));   // variance of z^2: 2
  EXPECT_NEAR(fourth / n, 3.0, 5.0 * std::sqrt(96.0 / n));  // variance of z^4: 105 - 9
}

TEST(RandomNumbers, StreamsAndSeedsDiffer) {
  host_sim::RandomNumbers a(1, 0), b(1, 1), c(2, 0), again(1, 0);
  const double first = a.uniform();
  EXPECT_NE(first, b.uniform());
  EXPECT_NE(first, c.uniform());
  EXPECT_EQ(first, again.uniform());
}

TEST(Cosine, ValueAndDerivatives) {
  const auto signal = host_sim::cosine(3.0, 2.0, 0.5);
  const host_sim::Motion m = signal->motion(0.1);
  const double phase = kTwoPi * 0.2 + 0.5, w = 2 * kTwoPi;
  EXPECT_NEAR(m.value, 3 * std::cos(phase), 1e-14);
  EXPECT_NEAR(m.rate, -3 * w * std::sin(phase), 1e-12);
  EXPECT_NEAR(m.acceleration, -3 * w * w * std::cos(phase), 1e-11);
}

// Amplitude of x at one frequency over whole cycles.
double amplitude_at(const host_sim::Signal& signal, double f_Hz, double duration_s) {
  double re = 0, im = 0;
  const int n = static_cast<int>(duration_s * 1000);
  for (int i = 0; i < n; ++i) {
    const double v = signal.value(1e-3 * i);
    re += v * std::cos(kTwoPi * f_Hz * 1e-3 * i);
    im += v * std::sin(kTwoPi * f_Hz * 1e-3 * i);
  }
  return 2 * std::hypot(re, im) / n;
}

// 20 s, 5 to 50 Hz, rms 10: nothing at 2 and 60 Hz, something inside, the derivative is that of the value.
TEST(RandomBand, HasItsRmsAndItsBand) {
  const auto signal = host_sim::random_band({10.0, 5.0, 50.0}, -2.0, 20.0, 1e-3, 11, 0);
  double square = 0, fourth = 0;
  for (int i = 0; i < 22000; ++i) {
    const double v = signal->value(-2.0 + 1e-3 * i);
    square += v * v;
    fourth += v * v * v * v;
  }
  EXPECT_NEAR(std::sqrt(square / 22000), 10.0, 0.05);
  EXPECT_NEAR(fourth / 22000 / 1e4, 3.0, 0.5);  // Gaussian
  double inside = 0;
  for (int k = 0; k < 20; ++k) inside += std::pow(amplitude_at(*signal, 6 + 2 * k, 20.0), 2) / 20;
  for (double outside : {1.0, 2.0, 60.0, 100.0})
    EXPECT_LT(amplitude_at(*signal, outside, 20.0), 0.05 * std::sqrt(inside));
  for (double t : {0.0123, 1.00077, 7.5}) {
    const double d = 1e-6;
    const host_sim::Motion m = signal->motion(t);
    EXPECT_NEAR(m.rate, (signal->value(t + d) - signal->value(t - d)) / (2 * d), 1e-3 * 10 * kTwoPi * 50);
  }
}

TEST(RandomBand, SameSeedSameBytesOtherLevelOther) {
  const auto a = host_sim::random_band({1.0, 5.0, 50.0}, 0.0, 1.0, 1e-3, 11, 0),
             b = host_sim::random_band({1.0, 5.0, 50.0}, 0.0, 1.0, 1e-3, 11, 0),
             c = host_sim::random_band({1.0, 5.0, 50.0}, 0.0, 1.0, 1e-3, 11, 1);
  for (double t : {0.0, 0.1234, 0.9}) {
    EXPECT_EQ(a->value(t), b->value(t));
    EXPECT_NE(a->value(t), c->value(t));
  }
}

// A 50 Hz cosine sampled at 1 kHz: quintic interpolation is off by (w h)^6 / 46080 = 2e-8 and the eighth-order
// differences' own error, (w h)^8 / 630 = 1.5e-7 of the second derivative's part; linear by (w h)^2 / 8 = 1.2e-2.
TEST(Sampled, InterpolatesBandLimitedData) {
  std::vector<double> values;
  for (int i = 0; i < 200; ++i) values.push_back(std::cos(kTwoPi * 0.05 * i));
  const auto quintic = host_sim::sampled(values, 0.0, 1e-3);
  const auto linear = host_sim::sampled(values, 0.0, 1e-3, host_sim::Interpolation::kLinear);
  double worst_quintic = 0, worst_linear = 0;
  for (double t = 0.02; t < 0.18; t += 1.37e-4) {
    worst_quintic = std::max(worst_quintic, std::fabs(quintic->value(t) - std::cos(kTwoPi * 50 * t)));
    worst_linear = std::max(worst_linear, std::fabs(linear->value(t) - std::cos(kTwoPi * 50 * t)));
  }
  EXPECT_LT(worst_quintic, 5e-7);
  EXPECT_GT(worst_linear, 5e-3);
  EXPECT_LT(worst_linear, 1.3e-2);
  EXPECT_EQ(quintic->value(-1.0), values.front());
  EXPECT_EQ(quintic->value(5.0), values.back());
  EXPECT_NEAR(quintic->value(0.007), values[7], 1e-12);
}

// Read in any order, also at the knots and beyond the ends, a reader says what the signal says, to the last bit.
TEST(SignalReader, SaysWhatTheSignalSays) {
  host_sim::RandomNumbers random(5, 1);
  std::vector<double> values;
  for (int i = 0; i < 50; ++i) values.push_back(random.normal());
  for (const host_sim::SignalPtr& signal : {host_sim::sampled(values, 0.25, 1e-3), host_sim::cosine(2.0, 7.0, 0.3),
                                            host_sim::sampled(values, 0.25, 1e-3, host_sim::Interpolation::kLinear)}) {
    host_sim::SignalReader reader(signal);
    for (double t = 0.24; t < 0.31; t += 1.7e-4) EXPECT_EQ(reader.value(t), signal->value(t)) << t;
    for (int i = 49; i >= 0; --i) EXPECT_EQ(reader.value(0.25 + i * 1e-3), signal->value(0.25 + i * 1e-3)) << i;
    for (int i = 0; i < 1000; ++i) {
      const double t = 0.275 + 0.01 * random.normal();
      EXPECT_EQ(reader.value(t), signal->value(t)) << t;
    }
  }
}

}  // namespace
