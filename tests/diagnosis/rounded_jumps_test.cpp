// Accelerometers behind a filter round the jumps of dry friction: what a simulation that jumps at once makes of them.
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/diagnosis/readings/rounding.hpp"
#include "tests/hidden_rig/draw.hpp"
#include "two_masses.hpp"

namespace {

using diagnosis::runs::Rounding;
using Vec = Eigen::VectorXd;

// 20 samples a period and more are motion: a thousandth at most is taken away. Of a jump half is left at its middle.
TEST(RoundedJumps, MotionStaysAndAJumpIsRounded) {
  constexpr int kCount = 400, kMiddle = 200;
  const double omega = 2 * 3.14159265358979 / 20;
  Vec wave(kCount), jump(kCount);
  for (int i = 0; i < kCount; ++i) wave[i] = std::sin(omega * i), jump[i] = i < kMiddle ? -1 : i == kMiddle ? 0 : 1;
  const Vec slow = Rounding(1).of(wave), round = Rounding(1).of(jump);
  EXPECT_LT((slow - wave).cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_NEAR(round[kMiddle], 0, 1e-12);
  EXPECT_LT(round[kMiddle + 1], 0.9);
  EXPECT_NEAR(round[kMiddle + 10], 1, 1e-3);
  EXPECT_EQ(round[0], jump[0]);
  EXPECT_EQ(Rounding(0).of(jump), jump);
}

// Accelerations and the force through a filter of fourth order that ends at a fifth of the rate: without the rounding two frictions of
// this rig read 5 % low, six and nine standard deviations.
TEST(RoundedJumps, FrictionBehindAFilterIsWithinItsInterval) {
  hidden_rig::Settings settings;
  settings.condition = "anti_alias_noise_after", settings.sensors = "a", settings.rho_low = 0.1;
  const hidden_rig::Draw draw = hidden_rig::make_draw(10300002, settings);
  const diagnosis::Diagnosis d = diagnosis::diagnose(draw.rig, draw.records, {});
  EXPECT_EQ(two_masses::said(d), "none");
  for (const hidden_rig::TrueCoefficient& c : draw.coefficients) {
    const diagnosis::Parameter p = two_masses::parameter_of(d.baseline, c.name);
    EXPECT_LT(std::abs(p.value - c.value), 3 * p.std) << c.name;
  }
}

}  // namespace
