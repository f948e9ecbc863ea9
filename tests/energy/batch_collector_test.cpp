// Packing and the merging of batches.
#include "firmware/energy/batch_collector.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "hal/rig_file/whole_cycles.hpp"

using namespace firmware;

namespace {
double to_double(PackedScaled p) {
  const Scaled s = unpack(p);
  return std::ldexp(static_cast<double>(s.mantissa), s.exponent);
}
}  // namespace

TEST(PackedScaled, KeepsFortySevenBits) {
  for (int64_t value :
       {int64_t{1}, int64_t{-1}, int64_t{123456789012345}, (int64_t{1} << 62) - 1, -((int64_t{1} << 62) - 1)}) {
    for (int exponent : {-300, 0, 300}) {
      const double exact = std::ldexp(static_cast<double>(value), exponent);
      EXPECT_NEAR(to_double(pack(Scaled::from_int(value, exponent))), exact, std::ldexp(std::fabs(exact), -47));
    }
  }
  EXPECT_EQ(to_double(pack(Scaled{})), 0.0);
}

// The short way of adding two stored numbers has the bits of the long one, whatever their signs and distance.
TEST(PackedScaled, SumsHaveTheBitsOfTheirWideForm) {
  uint64_t random = 1;
  const auto next = [&random] { return random = random * 6364136223846793005u + 1442695040888963407u; };
  for (int trial = 0; trial < 200000; ++trial) {
    const auto a = static_cast<int64_t>(next()) >> (next() >> 58), b = static_cast<int64_t>(next()) >> (next() >> 58);
    const int distance = static_cast<int>(next() >> 57) - 64;
    const PackedScaled left = pack(Scaled::from_int(a / 2, 5)), right = pack(Scaled::from_int(b / 2, 5 + distance));
    ASSERT_EQ((left + right).bits, pack(unpack(left) + unpack(right)).bits) << a << " " << b << " " << distance;
  }
  const PackedScaled one = pack(Scaled::from_int(3));
  EXPECT_EQ((one + pack(Scaled::from_int(-3))).bits, 0);
  EXPECT_EQ((one + PackedScaled{}).bits, one.bits);
  EXPECT_EQ((PackedScaled{} + one).bits, one.bits);
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
    collector.add(batch, 1);
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

// A merge that is spread over the samples is done before the next batch comes, whatever the batches' length, and leaves
// what a merge at once leaves.
TEST(BatchCollector, AMergeSpreadOverTheSamplesIsTheSameMerge) {
  RowLayout layout;
  layout.dof_count = layout.unknown_count = 1;
  for (int i = 1; i <= kMaxDofs; ++i) layout.first[i] = 1;
  for (uint32_t samples : {8u, 32u, 200u}) {
    CoreConfiguration configuration;
    configuration.dof_count = 1;
    configuration.window.batch_samples = samples;
    auto at_once = std::make_unique<BatchTable>(), spread = std::make_unique<BatchTable>();
    BatchCollector first(*at_once), second(*spread);
    for (BatchCollector* collector : {&first, &second}) {
      collector->clear(configuration, layout);
      collector->begin_level();
    }
    int merges_begun = 0;
    for (int b = 1; b <= 3 * kMaxBatches + 5; ++b) {
      Batch batch{};
      batch.samples = samples;
      batch.column[0][0] = pack(Scaled::from_int(b));
      batch.dof[0].rhs[0] = pack(Scaled::from_int(3 * b + 1));
      first.add(batch, 1);
      first.settle();
      second.add(batch, 1);
      const int before = second.merging() ? 1 : 0;
      for (uint32_t sample = 0; sample < samples; ++sample) second.advance();
      merges_begun += before;
    }
    EXPECT_GT(merges_begun, 0) << "the table was never full";
    EXPECT_FALSE(second.merging());
    const Level &a = at_once->level[0], &b = spread->level[0];
    ASSERT_EQ(a.batch_count, b.batch_count);
    EXPECT_EQ(a.merges, b.merges);
    for (int i = 0; i < a.batch_count; ++i) {
      EXPECT_EQ(a.batch[i].samples, b.batch[i].samples);
      EXPECT_EQ(a.batch[i].column[0][0].bits, b.batch[i].column[0][0].bits);
      EXPECT_EQ(a.batch[i].dof[0].rhs[0].bits, b.batch[i].dof[0].rhs[0].bits);
    }
  }
}

TEST(BatchCollector, UnitsOfACycleEndAtTheNearestSample) {
  // 250 samples a cycle: a sixteenth is 15.625 samples, so units end at 16, 31, 47, 63 (62.5 up), ..., 250.
  CoreConfiguration configuration;
  configuration.window = {WindowMode::kWholeCycles, 250, 1, 0};
  auto table = std::make_unique<BatchTable>();
  BatchCollector collector(*table);
  collector.clear(configuration, RowLayout{});
  EXPECT_EQ(collector.unit_end(1), 16u);
  EXPECT_EQ(collector.unit_end(2), 31u);
  EXPECT_EQ(collector.unit_end(4), 63u);
  EXPECT_EQ(collector.unit_end(16), 250u);
  EXPECT_EQ(collector.unit_end(160), 2500u);
}

TEST(BatchCollector, DropsWhatFollowsTheLastWholeCycle) {
  // Three cycles and 5 sixteenths, then an incomplete unit: 48 units stay.
  CoreConfiguration configuration;
  configuration.window = {WindowMode::kWholeCycles, 320, 1, 0};
  auto table = std::make_unique<BatchTable>();
  BatchCollector collector(*table);
  collector.clear(configuration, RowLayout{});
  collector.begin_level();
  for (int unit = 0; unit < 53; ++unit) {
    Batch batch{};
    batch.samples = 20;
    collector.add(batch, 1);
  }
  Batch rest{};
  rest.samples = 7;
  collector.add(rest, 0);
  collector.end_level();
  EXPECT_EQ(table->level[0].batch_count, 48);
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

// 65,500 samples a cycle in 1/65536: the sixteenth that is doubled until a unit has at most 1023 samples would pass 2^32.
// 64 units of 65500 / 64 = 1023.4 samples are too long, so 128: of 511.71875.
TEST(BatchCollector, UnitsOfLongCycles) {
  CoreConfiguration configuration;
  configuration.dof_count = configuration.unknown_count = 1;
  configuration.window.mode = WindowMode::kWholeCycles;
  configuration.window.cycle_samples_numerator = 65500u * 65536u;
  configuration.window.cycle_samples_denominator = 65536;
  RowLayout layout;
  layout.dof_count = layout.unknown_count = 1;
  auto table = std::make_unique<BatchTable>();
  BatchCollector collector(*table);
  collector.clear(configuration, layout);
  EXPECT_EQ(collector.unit_end(1), 512u);
  EXPECT_EQ(collector.unit_end(128), 65500u);
  EXPECT_EQ(collector.unit_end(3 * 128), 196500u);
}

// 100,000 samples in 2^-14 of one, and a cycle of 4 Mi samples that a fraction of 2^-8 still holds.
// A cycle of 65500 samples less 2^-16 in 128 units: 511.7 samples each, 511 or 512 whole ones, also behind 2^33 units, where 32 bits
// have run over twice. In steps of 2^26 units.
TEST(BatchCollector, UnitsOfAnEndlessLevel) {
  CoreConfiguration configuration;
  configuration.window.mode = WindowMode::kWholeCycles;
  configuration.window.cycle_samples_numerator = 65500u * 65536u - 1;
  configuration.window.cycle_samples_denominator = 65536;
  auto table = std::make_unique<BatchTable>();
  BatchCollector collector(*table);
  collector.clear(configuration, RowLayout{});
  uint32_t units = 0, samples = 0;
  for (int step = 0; step < 128; ++step) {
    collector.count_anew(units, samples);
    EXPECT_EQ(collector.unit_end(units), samples) << step;  // the same time in both
    for (uint32_t unit = 1; unit < 200; ++unit) {
      const uint32_t length = collector.unit_end(units + unit) - collector.unit_end(units + unit - 1);
      ASSERT_TRUE(length == 511 || length == 512) << step << ' ' << unit << ' ' << length;
    }
    ASSERT_LT(units, UINT32_MAX - (1u << 26)) << step;
    units += 1u << 26;
    samples = collector.unit_end(units);
  }
}

TEST(WholeCycles, AreFractionsThatFit) {
  firmware::WindowConfiguration window;
  rig_file::set_whole_cycles(100000.0, window);
  EXPECT_LT(window.cycle_samples_numerator, 1u << 30);
  EXPECT_EQ(window.cycle_samples_numerator, 100000.0 * window.cycle_samples_denominator);
  EXPECT_EQ(window.cycle_samples_denominator, 8192u);
  rig_file::set_whole_cycles(250.3, window);
  EXPECT_EQ(window.cycle_samples_denominator, 65536u);
  EXPECT_NEAR(window.cycle_samples_numerator / 65536.0, 250.3, 1.0 / 131072);
  rig_file::set_whole_cycles(1073741823.0, window);
  EXPECT_EQ(window.cycle_samples_denominator, 1u);
  EXPECT_THROW(rig_file::set_whole_cycles(1073741824.0, window), std::domain_error);
  EXPECT_THROW(rig_file::set_whole_cycles(3.9, window), std::domain_error);
}
