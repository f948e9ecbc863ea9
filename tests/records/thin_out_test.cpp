// Fewer samples of a record, behind a low-pass.
#include "host_sim/records/thin_out.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace {

using host_sim::Channel;
using host_sim::Quantity;
using host_sim::Record;
using host_sim::thinning_filter;

Record two_channels(size_t samples, double period_s, double frequency_Hz) {
  Record record;
  record.sample_period_s = period_s;
  record.start_s = 2.0;
  record.channels = {{"force_1_N", Quantity::kForce, 1, {}, 0.0, false},
                     {"displacement_1_m", Quantity::kDisplacement, 1, {}, 0.0, false}};
  for (size_t i = 0; i < samples; ++i) {
    const double t_s = record.start_s + period_s * static_cast<double>(i);
    record.channels[0].values.push_back(3.0 * std::sin(2.0 * M_PI * frequency_Hz * t_s));
    record.channels[1].values.push_back(5.0);
  }
  return record;
}

// 1000 samples, every fourth: 8 new periods are 32 samples, so the first is sample 32, the last one at most 1000 - 1 - 32 = 967:
// 32 + 4 * 233 = 964, which makes 234.
TEST(ThinOut, EveryFourthSampleAtItsOwnTime) {
  const Record fewer = host_sim::thinned(two_channels(1000, 1e-3, 20.0), 4);
  ASSERT_EQ(fewer.samples(), 234u);
  EXPECT_EQ(fewer.samples(), host_sim::thinned_samples(1000, 4));
  EXPECT_DOUBLE_EQ(fewer.sample_period_s, 4e-3);
  EXPECT_DOUBLE_EQ(fewer.start_s, 2.032);
  for (size_t i = 0; i < fewer.samples(); ++i) {
    const double t_s = 2.032 + 4e-3 * static_cast<double>(i);
    EXPECT_NEAR(fewer.channels[0].values[i], 3.0 * std::sin(2.0 * M_PI * 20.0 * t_s), 3.0 * 2e-3);
    EXPECT_NEAR(fewer.channels[1].values[i], 5.0, 1e-12);
  }
}

// What lies above three quarters of the new rate of 250 Hz is gone: 187.5 Hz, and as much further as a filter of 16 periods is blunt.
TEST(ThinOut, NothingFoldsFromFarAbove) {
  for (const double frequency_Hz : {210.0, 250.0, 330.0, 490.0}) {
    const Record fewer = host_sim::thinned(two_channels(2000, 1e-3, frequency_Hz), 4);
    for (const double value : fewer.channels[0].values) EXPECT_LT(std::fabs(value), 3.0 * 4e-3) << frequency_Hz;
  }
}

// The noises of new samples m apart share sum h[k] h[k + m N] of the old samples' variance: nothing.
TEST(ThinOut, WhiteNoiseStaysWhite) {
  for (const size_t factor : {2u, 3u, 7u, 40u}) {
    const std::vector<double> h = thinning_filter(factor);
    const double own = std::inner_product(h.begin(), h.end(), h.begin(), 0.0);
    EXPECT_NEAR(own * static_cast<double>(factor), 1.0, 0.01);
    for (size_t m = 1; m < host_sim::kThinningReach; ++m) {
      const long apart = static_cast<long>(m * factor);
      EXPECT_LT(std::fabs(std::inner_product(h.begin() + apart, h.end(), h.begin(), 0.0)), 0.003 * own)
          << factor << " " << m;
    }
  }
}

TEST(ThinOut, ARecordShorterThanTheFilterHasNothingLeft) {
  EXPECT_EQ(host_sim::thinned(two_channels(64, 1e-3, 20.0), 4).samples(), 0u);
  EXPECT_EQ(host_sim::thinned(two_channels(65, 1e-3, 20.0), 4).samples(), 1u);
  EXPECT_EQ(host_sim::thinned(two_channels(64, 1e-3, 20.0), 1).samples(), 64u);
}

}  // namespace
