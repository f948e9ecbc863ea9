// Packing and the merging of batches.
#include "firmware/energy/batch_collector.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

using namespace firmware;

namespace {
double to_double(PackedScaled p) {
  const Scaled s = unpack(p);
  return std::ldexp(static_cast<double>(s.mantissa), s.exponent);
}
}  // namespace

TEST(PackedScaled, KeepsFortySevenBits) {
  for (int64_t value : {int64_t{1}, int64_t{-1}, int64_t{123456789012345}, (int64_t{1} << 62) - 1, -((int64_t{1} << 62) - 1)}) {
    for (int exponent : {-300, 0, 300}) {
      const double exact = std::ldexp(static_cast<double>(value), exponent);
      EXPECT_NEAR(to_double(pack(Scaled::from_int(value, exponent))), exact, std::ldexp(std::fabs(exact), -47));
    }
  }
  EXPECT_EQ(to_double(pack(Scaled{})), 0.0);
}

TEST(BatchCollector, MergesPairsWhenFullAndLosesNothing) {
  // Batches of 32 samples with energy 1, 2, 3, ...: whatever merges, the sum over N batches is N (N + 1) / 2.
  CoreConfiguration configuration;
  configuration.dof_count = 1;
  configuration.unknown_count = 1;
  configuration.window.batch_samples = 32;
  RowLayout layout;
  layout.dof_count = layout.unknown_count = 1;
  for (int i = 1; i <= kMaxDofs; ++i) layout.first[i] = 1;
  auto table = std::make_unique<BatchTable>();
  BatchCollector collector(*table);
  collector.clear(configuration, layout);
  collector.begin_level();
  constexpr int kBatches = 5 * kMaxBatches + 7;
  for (int b = 1; b <= kBatches; ++b) {
    Batch batch{};
    batch.samples = 32;
    batch.column[0][0] = pack(Scaled::from_int(b));
    collector.add(batch);
  }
  collector.end_level();
  const Level& level = table->level[0];
  EXPECT_TRUE(level.closed);
  EXPECT_EQ(level.merges, 3);  // 64 batches at 32, 64 at 64, 64 at 128: 327 batches need lengths of 8 * 32
  double sum = 0.0;
  uint32_t samples = 0;
  for (int b = 0; b < level.batch_count; ++b) {
    sum += to_double(level.batch[b].column[0][0]);
    samples += level.batch[b].samples;
    if (b + 1 < level.batch_count) {
      EXPECT_EQ(level.batch[b].samples, 32u << level.merges);
    }
  }
  EXPECT_EQ(sum, kBatches * (kBatches + 1) / 2.0);
  EXPECT_EQ(samples, 32u * kBatches);
}

TEST(BatchCollector, RefusesALevelTooMany) {
  CoreConfiguration configuration;
  auto table = std::make_unique<BatchTable>();
  BatchCollector collector(*table);
  collector.clear(configuration, RowLayout{});
  for (int l = 0; l < kMaxLevels; ++l) collector.begin_level();
  EXPECT_FALSE(collector.refused());
  collector.begin_level();
  EXPECT_TRUE(collector.refused());
  EXPECT_EQ(table->level_count, kMaxLevels);
}
