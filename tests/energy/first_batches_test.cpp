// Longer first batches where a level's length is known: by hand, and against the batches of a core that is not told.
#include "hal/rig_file/first_batches.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "firmware/estimator_core.hpp"

namespace {

using namespace firmware;

// A table holds 128: of 32 samples 4096, of 64 8192. Two batches more of the longer kind are the margin: 66 * 64, 66 * 128.
TEST(FirstBatches, AreAsLongAsTheTableWouldMakeThem) {
  static_assert(kMaxBatches == 128, "the numbers below");
  EXPECT_EQ(rig_file::first_batch_samples(2000), 0u);
  EXPECT_EQ(rig_file::first_batch_samples(4223), 0u);
  EXPECT_EQ(rig_file::first_batch_samples(4224), 64u);
  EXPECT_EQ(rig_file::first_batch_samples(8447), 64u);
  EXPECT_EQ(rig_file::first_batch_samples(8448), 128u);
  EXPECT_EQ(rig_file::first_batch_samples(uint64_t{1} << 40), 128u);
}

// One mass on a spring and a damper, the damper unknown.
CoreConfiguration one_mass(uint32_t batch_samples) {
  CoreConfiguration c;
  c.dof_count = c.link_count = c.unknown_count = 1;
  c.sample_period_s = Scaled::ratio(1, 1000);
  c.links[0] = {0, kGroundNode};
  for (ChannelConfiguration& channel : c.channels[0]) {
    channel.present = true;
    channel.unit_per_code = Scaled::from_int(1, -10);
  }
  c.term_count = 3;
  const TermKind kinds[] = {TermKind::kMass, TermKind::kStiffness, TermKind::kViscous};
  for (int i = 0; i < 3; ++i) {
    c.terms[i].kind = kinds[i];
    c.terms[i].value = Scaled::from_int(3 + i);
  }
  c.terms[2].unknown = 0;
  copy_measured_signals(c);
  c.window.batch_samples = batch_samples;
  return c;
}

// Codes drawn at random; gap_every > 0: after so many samples one is missing.
struct LevelRun {
  explicit LevelRun(uint32_t batch_samples, uint32_t samples, uint32_t gap_every = 0)
      : configuration(one_mass(batch_samples)), core(std::make_unique<EstimatorCore>(configuration)) {
    uint64_t random = 1;
    RawSample sample;
    core->begin_level();
    for (uint32_t n = 0; n < samples; ++n) {
      for (int32_t& code : sample.code[0]) {
        random = random * 6364136223846793005u + 1442695040888963407u;
        code = static_cast<int32_t>(random >> 46) - (1 << 17);
      }
      sample.sequence = gap_every > 0 ? n + n / gap_every : n;
      core->push(sample);
    }
    core->end_level();
  }
  const Level& level() const { return core->table().level[0]; }

  CoreConfiguration configuration;
  std::unique_ptr<EstimatorCore> core;
};

double to_double(PackedScaled packed) {
  const Scaled value = unpack(packed);
  return std::ldexp(static_cast<double>(value.mantissa), value.exponent);
}

// Both tables' columns scatter about 1e7 J; a batch merged of four is rounded twice more, to 2^-47 of itself or its parts.
void expect_same_batches(const Level& a, const Level& b) {
  ASSERT_EQ(a.batch_count, b.batch_count);
  for (int i = 0; i < a.batch_count; ++i) {
    EXPECT_EQ(a.batch[i].samples, b.batch[i].samples) << i;
    const double column = to_double(a.batch[i].column[0][0]), scatter = std::fabs(to_double(a.batch[i].dof[0].rhs[0]));
    EXPECT_NEAR(to_double(b.batch[i].column[0][0]), column, 1e-12 * column) << i;
    EXPECT_NEAR(to_double(b.batch[i].dof[0].rhs[0]), to_double(a.batch[i].dof[0].rhs[0]), 1e-12 * (column + scatter))
        << i;
  }
}

TEST(FirstBatches, LeaveTheBatchesThatALevelWouldHaveHad) {
  for (const uint32_t samples : {4224u, 4300u, 8191u, 8447u, 8448u, 8600u, 12345u, 20129u, 40000u}) {
    SCOPED_TRACE(samples);
    const uint32_t first = rig_file::first_batch_samples(samples);
    ASSERT_GT(first, 0u);
    const LevelRun told(first, samples), not_told(0, samples);
    expect_same_batches(not_told.level(), told.level());
    EXPECT_LT(told.level().merges, not_told.level().merges);
  }
  // One twice as long would not: of 4300 samples 33 batches of 128 in place of 67 of 64.
  EXPECT_LT(LevelRun(128, 4300).level().batch_count, LevelRun(0, 4300).level().batch_count - 30);
}

// A sample is missing after each hundred: no batch of 128 is ever whole, two pieces make one.
TEST(FirstBatches, GapsLeaveEnoughOfThem) {
  const LevelRun told(128, 20000, 100);
  const Level& level = told.level();
  EXPECT_GE(level.batch_count, 64);
  for (int i = 0; i < level.batch_count; ++i) EXPECT_LE(level.batch[i].samples, 512u) << i;
}

}  // namespace
