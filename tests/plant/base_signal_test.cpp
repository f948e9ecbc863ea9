// The base of a simulation: smooth, whatever noise its sensor has.
#include "host_sim/plant/motion/base_signal.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/plant/instruments/smoothed.hpp"
#include "host_sim/plant/motion/free_run.hpp"
#include "tests/plant/rigs.hpp"

namespace {

using host_sim::Quantity;

// Noise of one size that no neighbour shares: signs of the Thue-Morse sequence, +--+-++--++-+--+...
double sign_of(unsigned k) {
  unsigned ones = 0;
  for (; k > 0; k /= 2) ones += k % 2;
  return ones % 2 ? -1.0 : 1.0;
}

host_sim::Record base_record(Quantity quantity, double noise) {
  host_sim::Record record;
  record.sample_period_s = 1e-3;
  std::vector<double> values;
  for (unsigned k = 0; k < 2001; ++k)
    values.push_back((quantity == Quantity::kDisplacement ? 1e-3 * std::sin(0.05 * k) : 0.05 * std::cos(0.05 * k)) +
                     noise * sign_of(k));
  record.channels.push_back({"", quantity, rig_file::kBase, values});
  return record;
}

// No third difference of a parabola is anything but nought, and of a slow sine hardly any: nothing is smoothed.
TEST(Smoothed, CleanSamplesStayAsTheyAre) {
  std::vector<double> parabola, sine;
  for (int k = 0; k < 200; ++k) parabola.push_back(0.5 * k * k), sine.push_back(std::sin(0.05 * k));
  const auto same = host_sim::smoothed(parabola), slow = host_sim::smoothed(sine);
  for (size_t k = 0; k < 200; ++k) {
    EXPECT_NEAR(same[k], parabola[k], 1e-6);
    EXPECT_NEAR(slow[k], sine[k], 1e-6);
  }
  EXPECT_EQ(host_sim::smoothed({1.0, 5.0, 2.0}), (std::vector<double>{1.0, 5.0, 2.0}));
}

// rms of what the rate of the base misses of 50 mm/s cos 50 t, away from the ends.
double rate_error(const host_sim::Record& record) {
  const auto base = host_sim::base_signal(record, 0.0, host_sim::Interpolation::kQuintic);
  double square = 0.0;
  int count = 0;
  for (int k = 100; k < 1900; ++k, ++count)
    square += std::pow(base->motion(1e-3 * k).rate - 0.05 * std::cos(0.05 * k), 2);
  return std::sqrt(square / count);
}

// 1 mm at 50 rad/s has a rate of 50 mm/s at most. Noise of 6 um on samples of 1 ms has a slope of some 6 mm/s, more than a tenth of
// that; smoothed, the rate is right to a fiftieth.
TEST(BaseSignal, ItsRateIsNotTheSlopeOfNoise) {
  EXPECT_LT(rate_error(base_record(Quantity::kDisplacement, 6e-6)), 1e-3);
}

// Known by its velocity, +-2 mm/s: at least three quarters of the noise's power go before it is integrated.
TEST(BaseSignal, AVelocityIsSmoothedBeforeItIsIntegrated) {
  EXPECT_LT(rate_error(base_record(Quantity::kVelocity, 2e-3)), 1e-3);
}

// Friction on it turns round with the motion, twice a period of 126 ms, and not with the noise: the run takes no more steps than its
// samples ask for.
TEST(BaseSignal, FrictionOnANoisyBaseRuns) {
  const auto rig = plant_test::oscillator(1.5, 4000.0, 6.0, 0.8, rig_file::kBase);
  host_sim::FreeRunOptions options;
  options.integrator.most_steps_per_sample = 100;
  const auto noisy = base_record(Quantity::kDisplacement, 6e-6), clean = base_record(Quantity::kDisplacement, 0.0);
  const auto a = host_sim::free_run(rig, noisy, 0, {}, 2001, options);
  const auto b = host_sim::free_run(rig, clean, 0, {}, 2001, options);
  for (size_t k = 0; k < 2001; k += 10)
    EXPECT_NEAR(a.find(Quantity::kDisplacement, 1)->values[k], b.find(Quantity::kDisplacement, 1)->values[k], 3e-5);
}

}  // namespace
