// Rates and signs of links between channels of equal and of different units.
#include "firmware/links/link_motion.hpp"

#include <gtest/gtest.h>

#include <memory>

using namespace firmware;

namespace {

std::unique_ptr<CoreConfiguration> two_dofs(Scaled unit_a, Scaled unit_b) {
  auto c = std::make_unique<CoreConfiguration>();
  c->dof_count = 2;
  c->signals[0][2].available = c->signals[1][2].available = true;
  c->signals[0][2].unit_per_code = unit_a;
  c->signals[1][2].unit_per_code = unit_b;
  return c;
}

int sign_of(const CoreConfiguration& c, LinkConfiguration link, int32_t va, int32_t vb, bool smoothed = false) {
  auto frame = std::make_unique<Frame>();
  for (int i = 0; i < kFrameStride; ++i) {
    frame->raw[signal_column(0, Quantity::kVelocity)][i] = va;
    frame->raw[signal_column(1, Quantity::kVelocity)][i] = vb;
  }
  Rate rate[kFrameStride];
  int32_t sign[kFrameStride];
  link_rate(rate_gains(c, link), *frame, smoothed, 5, 6, rate);
  signs(rate, 5, 6, Column<Code>(sign));
  return sign[5];
}

}  // namespace

TEST(LinkMotion, EqualUnitsCompareExactly) {
  const auto c = two_dofs(Scaled::from_int(1), Scaled::from_int(1));
  for (bool smoothed : {false, true}) {
    EXPECT_EQ(sign_of(*c, {0, 1}, 8388607, 8388606, smoothed), 1);
    EXPECT_EQ(sign_of(*c, {0, 1}, -8388607, -8388606, smoothed), -1);
    EXPECT_EQ(sign_of(*c, {0, 1}, 12345, 12345, smoothed), 0);  // exactly at rest: neither direction
    EXPECT_EQ(sign_of(*c, {1, 0}, 2, 1, smoothed), -1);
  }
}

TEST(LinkMotion, DifferentUnits) {
  // Code of DOF 1 worth 1, of DOF 2 worth 3/7: 3 codes against 7 codes is rest, one code more decides.
  const auto c = two_dofs(Scaled::from_int(1), Scaled::ratio(3, 7));
  EXPECT_EQ(sign_of(*c, {0, 1}, 300000, 700000), 0);
  EXPECT_EQ(sign_of(*c, {0, 1}, 300000, 700001), -1);
  EXPECT_EQ(sign_of(*c, {0, 1}, 300000, 699999), 1);
}

TEST(LinkMotion, GroundIsAtRest) {
  const auto c = two_dofs(Scaled::from_int(1), Scaled::from_int(1));
  EXPECT_EQ(sign_of(*c, {0, kGroundNode}, 1, 999), 1);
  EXPECT_EQ(sign_of(*c, {1, kGroundNode}, 999, -1), -1);
}

TEST(LinkMotion, SmoothingIsLinearInTime) {
  // v = -1, 1, 3, 5, 7 at positions 3 to 7: (4, 1, 10, 1, 4) . v = -4 + 1 + 30 + 5 + 28 = 60 = 20 * 3.
  const auto c = two_dofs(Scaled::from_int(1), Scaled::from_int(1));
  auto frame = std::make_unique<Frame>();
  for (int i = 0; i < kFrameStride; ++i) frame->raw[signal_column(0, Quantity::kVelocity)][i] = 2 * i - 7;
  Rate plain[kFrameStride], smooth[kFrameStride];
  const RateGains gains = rate_gains(*c, {0, kGroundNode});
  link_rate(gains, *frame, false, 5, 6, plain);
  link_rate(gains, *frame, true, 5, 6, smooth);
  EXPECT_EQ(smooth[5].raw, 20 * plain[5].raw);
}
