// The unit that a probe's sums count in grows with the motion, and nothing that was summed is lost.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core_run.hpp"
#include "firmware/warrant/sums/score_sums.hpp"
#include "hal/rig_file/scaled_double.hpp"

namespace {

using namespace firmware;
using rig_file::to_double;

// One equation, no column: w^3 times the known part goes with the third power of the rate's unit, times its own force with the sixth.
struct OneCube {
  ProbePlan plan;
  PlaceScale scale[1];
  ScoreTable table;
  OneCube() {
    plan.place_count = 1;
    plan.place[0].equations = 1;
    plan.probe_count = plan.summed_count = 1;
    plan.probe[0].form = Form::kRateCube;
    scale[0].shift[1] = kTableScaleShift;
    table.configure(2, &plan, scale);
    table.begin_level();
  }
  void double_the_unit() {
    table.rescale(0, 3);
    table.rescale(1, 6);
    ++scale[0].shift[1];
  }
  void add(int64_t first, int64_t second) {
    table.current(0) += first;
    table.current(1) += second;
  }
};

// 40 of the old unit are 5 of one that is eight times as large; 5 + 1 of it are 48 of the old. 640 are 10 of 64: 11 are 704.
// 44 are 5.5, which goes to 6; -44 to -5.
TEST(ScoreTable, WhatWasSummedCountsInTheNewUnit) {
  static OneCube one;
  one.add(40, 640);
  one.double_the_unit();
  one.add(1, 1);
  one.table.add_block(0);
  EXPECT_EQ(to_double(one.table.value(0, 0)), 48.0);
  EXPECT_EQ(to_double(one.table.value(0, 1)), 704.0);
  one.add(44, 0);
  one.table.rescale(0, 3);
  EXPECT_EQ(one.table.current(0), 6);
  one.table.current(0) = -44;
  one.table.rescale(0, 3);
  EXPECT_EQ(one.table.current(0), -5);
}

// Sums at full scale, 2^61, by any number of bits; the smallest and the largest unit stay within the table's 8-bit exponents:
// one of the least unit is 2^(6 * -14), 2^40 (a sample's 2^18 of one of the largest, three times over, and 2^32 samples) 2^(6 * 13 + 40).
TEST(ScoreTable, UnitsAtTheirBounds) {
  static OneCube one;
  for (const int sign : {1, -1}) {
    one.table.current(0) = sign * (int64_t{1} << 61);
    one.table.rescale(0, 60);
    EXPECT_EQ(one.table.current(0), sign * 2);
    one.table.current(0) = sign * (int64_t{1} << 61);
    one.table.rescale(0, 81);
    EXPECT_EQ(one.table.current(0), 0);
  }
  one.scale[0].shift[1] = kLeastScaleShift;
  one.add(0, 1);
  one.table.add_block(0);
  EXPECT_EQ(to_double(one.table.value(0, 1)), 0x1p-84);
  one.scale[0].shift[1] = 9;
  one.add(0, int64_t{1} << 40);
  one.table.add_block(0);
  EXPECT_EQ(to_double(one.table.value(1, 1)), 0x1p118);
}

// The 257th block finds the table full: it waits beside a merge, in the unit of its time, and counts in the new one afterwards.
TEST(ScoreTable, WhatWaitsForAMergeCountsInTheNewUnit) {
  static OneCube one;
  for (int block = 0; block <= 256; ++block) {
    one.add(8, 64);
    one.table.add_block(0);
  }
  ASSERT_TRUE(one.table.merging());
  one.double_the_unit();
  one.table.settle();
  ASSERT_EQ(one.table.stretches(), 129);
  EXPECT_EQ(to_double(one.table.value(0, 0)), 16.0);
  EXPECT_EQ(to_double(one.table.value(128, 0)), 8.0);
  EXPECT_EQ(to_double(one.table.value(128, 1)), 64.0);
}

// A rate of 2^-20 m/s a code: v = sin(n / 9) times 100 codes, and from sample 400 on 3,000,000. One link to the ground, whose rate
// probe sums the rate from the neighbours times the rate. In the unit of the first samples the later ones are at 30,000 units.
TEST(ScoreSums, AMotionThatOutgrowsItsUnitLosesNothing) {
  static CoreConfiguration c;
  c.dof_count = c.link_count = 1;
  c.links[0].node_a = 0;
  c.links[0].node_b = static_cast<uint8_t>(kGroundNode);
  c.sample_period_s = Scaled::ratio(1, 1000);
  c.probe_products_per_sample = kAllProbes;
  for (int q = 0; q < kQuantities; ++q) {
    c.channels[0][q].present = true;
    c.channels[0][q].unit_per_code = Scaled::from_int(1, -20);
  }
  copy_measured_signals(c);
  c.term_count = 1;
  c.unknown_count = 1;
  c.terms[0].kind = TermKind::kViscous;
  c.terms[0].unknown = 0;
  static ScoreSums sums;
  Scaled no_effects[1];
  sums.configure(c, no_effects, {});
  sums.begin_level();
  constexpr size_t kFrames = 40, kBlock = kBlockSamples;
  std::vector<int32_t> v;
  v.reserve(kFrames * kBlock);
  for (size_t n = 0; n < kFrames * kBlock; ++n)
    v.push_back(static_cast<int32_t>(std::lround((n < 400 ? 100 : 3000000) * std::sin(static_cast<double>(n) / 9.0))));
  static Frame frame;
  for (size_t f = 0; f < kFrames; ++f) {
    for (size_t i = 0; i < kBlock; ++i)
      frame.raw[signal_column(0, Quantity::kVelocity)][kLeadIn + i] = v[f * kBlock + i];
    sums.offer(frame, kBlockSamples);
  }
  sums.flush();
  const ScoreTable& table = sums.table();
  constexpr size_t kBlocks = (kFrames * kBlock - 2 * kNeighbours) / kBlock;
  ASSERT_EQ(static_cast<size_t>(table.stretches()), kBlocks);  // every one, from the first sample on
  const double weights[] = {54.0 / 172, 39.0 / 172, 14.0 / 172, -21.0 / 172};
  const Probe& rate = sums.plan().probe[0];
  ASSERT_EQ(rate.form, Form::kRate);
  const int own = sums.plan().own_value(rate);
  for (size_t s = 0; s < kBlocks; ++s) {
    double expected = 0, codes = 0;
    for (size_t i = 0; i < kBlock; ++i) {
      const size_t at = kNeighbours + s * kBlock + i;
      double near = 0;
      for (size_t k = 1; k <= 4; ++k) near += weights[k - 1] * (v[at - k] + v[at + k]);
      expected += near * v[at] * 0x1p-40;
      codes += std::abs(v[at]);
    }
    const double sum = to_double(table.value(static_cast<int>(s), own) * sums.unit(rate, own - rate.first_value));
    EXPECT_NEAR(sum, expected, 0x1p-43 * codes + 1e-5 * expected) << s;  // what is near counts eighths of a code
  }
}

// A decay of half a second: half of it used to be spent on finding the unit, and nothing was tested.
TEST(Warrant, TheLoudBeginningOfADecayIsTested) {
  const auto run_of = [](const char* hidden, uint64_t seed) {
    hidden_rig::Settings settings;
    settings.condition = "free_decay";
    settings.hidden = hidden;
    settings.rho_low = 0.4;
    settings.masses = 1;
    hidden_rig::Draw draw = hidden_rig::make_draw(seed, settings);
    draw.records.resize(1);
    for (host_sim::Channel& channel : draw.records.front().channels) channel.values.resize(500);
    return warrant_test::run_core(draw);
  };
  int found = 0;
  for (uint64_t seed = 8750; seed < 8758; ++seed) {
    const warrant_test::CoreRun right = run_of("none", seed);
    EXPECT_TRUE(right.core->estimates().warrant.tested) << seed;
    EXPECT_EQ(right.core->estimates().warrant.named.cause, Cause::kNone) << seed;
    for (const EffectKind effect : {EffectKind::kQuadraticStiffness, EffectKind::kForceOffset}) {
      const warrant_test::CoreRun run = run_of(row_of(effect).word.text, seed);
      found += run.core->estimates().warrant.named.cause == cause_of(effect);
    }
  }
  EXPECT_GE(found, 14);  // of 16
}

}  // namespace
