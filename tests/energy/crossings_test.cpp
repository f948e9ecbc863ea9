// The sign change located inside the sample interval.
#include "firmware/energy/crossings.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace firmware;

namespace {

int64_t correction(int64_t w0, int64_t w1, int32_t q0, int32_t q1) {
  return crossing_correction(Rate::from_raw(w0), Rate::from_raw(w1), Code::from_raw(q0), Code::from_raw(q1)).raw;
}

}  // namespace

TEST(Crossings, HalfWayWithConstantWeightChangesNothing) {
  // theta = 1/2, q0 = q1: the trapezoid (q - q)/2 = 0 and the exact integral 0.5 q - 0.5 q = 0 agree.
  EXPECT_EQ(correction(1000, -1000, 4096, 4096), 0);
}

TEST(Crossings, QuarterWayWithConstantWeight) {
  // theta = 1/4, sign + then -: exact 0.25 q - 0.75 q = -q/2, trapezoid 0: correction -q/2 = -2048 (Q16: * 65536).
  EXPECT_EQ(correction(1000, -3000, 4096, 4096), -2048 * 65536);
  EXPECT_EQ(correction(-1000, 3000, 4096, 4096), 2048 * 65536);
}

TEST(Crossings, WeightEqualToTheRate) {
  // q = w = 3000 -> -1000: theta = 3/4, step = -4000.
  // (2 theta - 1) q0 = 1500; (theta^2 - 1/6) step = (9/16 - 1/6) (-4000) = -1583.33; together -83.33.
  const double located = static_cast<double>(correction(3000, -1000, 3000, -1000)) / 65536.0;
  EXPECT_NEAR(located, 1500.0 - (9.0 / 16.0 - 1.0 / 6.0) * 4000.0, 0.1);
}

TEST(Crossings, AbsoluteValueOfASineAtHundredSamplesACycle) {
  // Integral of |sin| over whole cycles is 4 per cycle of length 2 pi. The bare trapezoid at 100 samples a cycle, the phase
  // such that no sample hits a zero, is off by (w h)^2 / 12 and more; corrected it must be better than 1e-5.
  constexpr int kCycle = 100, kCycles = 3, kCount = kCycle * kCycles;
  const double step = 2.0 * M_PI / kCycle, phase = 0.37 * step;
  Rate rate[kCount + 1];
  int32_t weight[kCount + 1];
  double trapezoid = 0.0;
  for (int n = 0; n <= kCount; ++n) {
    weight[n] = static_cast<int32_t>(std::lround(std::sin(n * step + phase) * (1 << 22)));
    rate[n] = Rate::from_raw(weight[n]);
    if (n < kCount) trapezoid += std::fabs(static_cast<double>(weight[n]));
  }
  const double corrected =
      trapezoid + static_cast<double>(crossing_corrections(rate, ConstColumn<Code>(weight), 0, kCount).raw) / 65536.0;
  const double exact = 4.0 * kCycles / step * (1 << 22);
  EXPECT_GT(std::fabs(trapezoid / exact - 1.0), 1e-4);
  EXPECT_LT(std::fabs(corrected / exact - 1.0), 1e-5);
}
// Preconditions are checked in every test: a rate that does not change its sign has no crossing.
TEST(Crossings, APreconditionThatDoesNotHoldEndsTheProgram) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_DEATH(correction(5, 3, 1, 1), "");
}
