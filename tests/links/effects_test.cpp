// What columns of effects do beyond the laws of one instant (those: tests/vocabulary/core_laws_test.cpp).
#include "firmware/links/effects.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>

using namespace firmware;

namespace {

constexpr double kUnitX = 1.0 / (1 << 24), kUnitV = 1.0 / (1 << 20);
constexpr double kPeriod = 0.001;

double to_double(Scaled s) { return std::ldexp(static_cast<double>(s.mantissa), s.exponent); }
Scaled from_double(double x) { return Scaled::from_int(static_cast<int64_t>(std::ldexp(x, 50)), -50); }

// One DOF to ground with u(t), w(t); the column of the effect in SI units over one block.
struct Case {
  std::unique_ptr<CoreConfiguration> configuration = std::make_unique<CoreConfiguration>();
  std::unique_ptr<Frame> frame = std::make_unique<Frame>();
  std::unique_ptr<Effects> effects = std::make_unique<Effects>();
  Scaled unit[kMaxColumns];

  Case(TermKind kind, double shape) {
    CoreConfiguration& c = *configuration;
    c.dof_count = c.link_count = c.term_count = 1;
    c.sample_period_s = from_double(kPeriod);
    c.terms[0].kind = kind;
    c.terms[0].shape = from_double(shape);
    c.signals[0][1].unit_per_code = from_double(kUnitX);
    c.signals[0][2].unit_per_code = from_double(kUnitV);
    effects->configure(c, unit);
    effects->restart();
  }
  void block(int first_sample, const std::function<double(double)>& u, const std::function<double(double)>& w) {
    for (int i = 0; i < kFrameStride; ++i) {
      const double t = (first_sample + i - kLeadIn) * kPeriod;
      frame->raw[signal_column(0, Quantity::kDisplacement)][i] = static_cast<int32_t>(std::lround(u(t) / kUnitX));
      frame->raw[signal_column(0, Quantity::kVelocity)][i] = static_cast<int32_t>(std::lround(w(t) / kUnitV));
    }
    effects->fill(*frame, kLeadIn - 1, kLeadIn + kBlockSamples + 2, kBlockSamples);
  }
  double at(int i) const { return frame->raw[kEffectColumn][kLeadIn + i] * to_double(unit[kEffectColumn]); }
};

}  // namespace

TEST(Effects, GravityBeyondOneTurn) {
  Case test(TermKind::kGravity, 0.0);
  test.configuration->signals[0][1].unit_per_code = from_double(1.0 / (1 << 18));  // 32 rad at full scale
  test.effects->configure(*test.configuration, test.unit);
  for (int i = 0; i < kFrameStride; ++i)
    test.frame->raw[signal_column(0, Quantity::kDisplacement)][i] = (i - 20) * 262144;  // i - 20 rad
  test.effects->fill(*test.frame, kLeadIn - 1, kLeadIn + kBlockSamples + 2, kBlockSamples);
  for (int i = 0; i < kBlockSamples; ++i) EXPECT_NEAR(test.at(i), std::sin(i + kLeadIn - 20.0), 2e-6);
}

TEST(Effects, TimeRunsOnFromBlockToBlock) {
  Case test(TermKind::kDriftingViscous, 0.0);
  const auto rest = [](double) { return 0.0; };
  const auto steady = [](double) { return 2.0; };
  for (int block = 0; block < 50; ++block) test.block(block * kBlockSamples, rest, steady);
  // Time counts from one sample before the first block: sample 49 * 32 + 7 stands at index 1576.
  EXPECT_NEAR(test.at(7), 2.0 * 1576 * kPeriod, 1e-2);
}

// With a time constant of 0.5 s: 2 * 0.5 (1 - exp(-t / 0.5)), at the start and where it has nearly levelled off.
TEST(Effects, ADriftLevelsOff) {
  Case test(TermKind::kDriftingViscous, 0.5);
  const auto rest = [](double) { return 0.0; };
  const auto steady = [](double) { return 2.0; };
  for (int block = 0; block < 50; ++block) {
    test.block(block * kBlockSamples, rest, steady);
    const double t = (block * kBlockSamples + 8) * kPeriod;  // counted from one sample before the first block
    EXPECT_NEAR(test.at(7), 1.0 - std::exp(-t / 0.5), 1e-6);
  }
}

// To 2^20 samples where it does not level off; a column is filled from kLeadIn - 1 to kLeadIn + kBlockSamples + 1, which is
// kBlockSamples + 2 behind the first. One that levels off counts to 2^32 - 1.
TEST(Effects, TimeIsOutWhereADriftHasNoRoom) {
  const auto still = [](double) { return 0.0; };
  for (const double shape : {0.0, 0.5}) {
    Case test(TermKind::kDriftingViscous, shape);
    const uint32_t last = shape > 0.0 ? UINT32_MAX : 1u << kLawTimeBits;
    test.effects->restart(last - kBlockSamples - 3);
    test.block(0, still, still);
    EXPECT_FALSE(test.effects->time_is_out());
    test.block(0, still, still);
    EXPECT_TRUE(test.effects->time_is_out());
    test.effects->restart();
    EXPECT_FALSE(test.effects->time_is_out());
  }
}

TEST(Effects, DahlFrictionSaturatesAndTurns) {
  // Pulled steadily: z = 1 - exp(-u / length) from rest; after a reversal it heads for -1 with the same length.
  Case test(TermKind::kPreslidingHysteresis, 0.01);
  const auto pull = [](double t) { return 0.1 * (t + kPeriod); };  // u = 0 one sample before the first block
  const auto rate = [](double t) { return t < 0 ? 0.0 : 0.1; };    // still at rest where the level starts
  for (int block = 0; block < 10; ++block) {
    test.block(block * kBlockSamples, pull, rate);
    for (int i : {0, 10, 31}) {
      const double u = pull((block * kBlockSamples + i) * kPeriod);
      EXPECT_NEAR(test.at(i), 1.0 - std::exp(-u / 0.01), 1e-5);
    }
  }
}
