// When does a response count as settled?
#include "firmware/excitation/settle_detector.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using firmware::SettleCriterion;
using firmware::SettleDetector;

SettleCriterion criterion() {
  SettleCriterion made;
  made.block_samples = 100;
  made.bound_per_mille = 20;
  made.blocks = 4;
  made.floor_code = 2;
  return made;
}

// The sample count at which the response settles, or -1 within `limit`.
template <typename Response>
int settling_sample(const SettleCriterion& asked, int limit, Response response) {
  SettleDetector detector;
  detector.begin(asked, 1);
  for (int i = 0; i < limit; ++i) {
    const auto code = static_cast<int32_t>(std::lround(response(i)));
    if (detector.push(&code)) return i + 1;
  }
  return -1;
}

double cycle(int i) { return std::sin(2.0 * M_PI * i / 100.0); }

TEST(SettleDetector, SteadySineSettlesAfterTheLastBlockNeeded) {
  EXPECT_EQ(settling_sample(criterion(), 1000, [](int i) { return 1e5 * cycle(i); }), 400);
}

TEST(SettleDetector, WaitsForATransientToDieOut) {
  // Amplitude 1 - exp(-t): energy 1 - 2 exp(-t) + ..., blocks of T = 100 samples, time constant tau = 500 samples.
  // The spread over 4 blocks, from block k to block k + 3, is about 2 exp(-k T / tau) (1 - exp(-3 T / tau)) times a
  // factor near 0.9 for the mean over a block; it falls below 0.02 for k = 20 (2 * 0.0183 * 0.45 * 0.9 = 0.0149) and is
  // still above for k = 18 (0.0222): so the last of the four blocks is number 22 to 24.
  const int settled =
      settling_sample(criterion(), 20000, [](int i) { return 1e6 * (1 - std::exp(-i / 500.0)) * cycle(i); });
  EXPECT_GE(settled, 2200);
  EXPECT_LE(settled, 2400);
}

TEST(SettleDetector, ABeatKeepsItWaiting) {
  // 10 % of a neighbouring frequency, beating over 8 blocks without decay: the energy swings by +-20 %.
  const auto beating = [](int i) { return 1e6 * (cycle(i) + 0.1 * std::sin(2.0 * M_PI * i / 100.0 * 1.125)); };
  EXPECT_EQ(settling_sample(criterion(), 50000, beating), -1);
}

TEST(SettleDetector, ConstantOffsetDoesNotHideTheTransient) {
  const auto decaying = [](int i) { return 4e6 + 1e4 * std::exp(-i / 2000.0) * cycle(i); };
  const int settled = settling_sample(criterion(), 100000, decaying);
  // Energy ratio over three blocks: exp(-2 * 300 / 2000) = 0.74: never within 2 %; only the floor of 2 codes rms ends
  // it: 1e4 / sqrt 2 exp(-t / 2000) = 2 at t = 2000 ln 3536 = 16,340.
  EXPECT_GE(settled, 16300);
  EXPECT_LE(settled, 16800);
}

TEST(SettleDetector, EveryDofMustSettle) {
  SettleDetector detector;
  detector.begin(criterion(), 2);
  bool settled = false;
  for (int i = 0; i < 5000; ++i) {
    const double growth = 1.0 + i / 1000.0;
    const int32_t codes[2] = {static_cast<int32_t>(1e5 * cycle(i)), static_cast<int32_t>(1e5 * growth * cycle(i))};
    settled = settled || detector.push(codes);
  }
  EXPECT_FALSE(settled);
}

TEST(SettleDetector, NothingToWaitForSettlesAtOnce) {
  SettleCriterion none = criterion();
  none.block_samples = 0;
  EXPECT_EQ(settling_sample(none, 10, [](int) { return 0.0; }), 1);
}

TEST(SettleDetector, LongestBlockAtFullScale) {
  // 65,535 samples of +-2^23: variance exactly 2^46 less a hair for the odd count. A sum that overflowed would not
  // settle on it and the alternation against a constant would look alike.
  SettleCriterion longest = criterion();
  longest.block_samples = SettleDetector::kMaxBlockSamples;
  longest.blocks = 2;
  longest.floor_code = 0;
  const auto full_scale = [](int i) { return i % 2 ? -8388608.0 : 8388608.0; };
  EXPECT_EQ(settling_sample(longest, 200000, full_scale), 131070);
  // Full scale in the first block, half in the second: must not settle before the third and fourth agree (blocks 2 and
  // 3).
  const auto halved = [](int i) { return (i < 65535 ? 1.0 : 0.5) * (i % 2 ? -8388608.0 : 8388608.0); };
  EXPECT_EQ(settling_sample(longest, 300000, halved), 3 * 65535);
  // A constant at full scale has no energy about its mean.
  EXPECT_EQ(settling_sample(longest, 300000, [](int) { return 8388607.0; }), 131070);
}

}  // namespace
