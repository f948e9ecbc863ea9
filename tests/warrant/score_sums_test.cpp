// The fixed point of the score tests at its bounds, and sums worked out by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "firmware/energy/product_sums.hpp"
#include "firmware/warrant/probes/probe_force.hpp"
#include "firmware/warrant/sums/score_table.hpp"
#include "hal/rig_file/scaled_double.hpp"

namespace {

using namespace firmware;
using rig_file::to_double;

// 2^24 * 2^27 * 32 samples * 32 blocks = 2^61: the exact sums at full scale, of either sign.
TEST(ScoreTable, ExactSumsHoldFullScale) {
  static int32_t phi[kBlockSamples], column[kBlockSamples];
  static ScoreTable table;
  for (const int sign : {1, -1}) {
    for (int i = 0; i < kBlockSamples; ++i) {
      phi[i] = 1 << 24;
      column[i] = sign * (1 << 27);
    }
    int64_t sum = 0;
    for (int block = 0; block < static_cast<int>(kExactBlocks); ++block) sum += dot_block(phi, column);
    EXPECT_EQ(sum, sign * (int64_t{1} << 61));
  }
  // Stretches of one block first; full at 256, they double: 8192 blocks of 2^56 in 256 stretches of 32.
  table.configure(1, nullptr, nullptr);
  table.begin_level();
  for (int block = 0; block < 8192; ++block) {
    table.current(0) += int64_t{1} << 56;
    table.add_block(0);
  }
  ASSERT_EQ(table.stretches(), 256);
  for (int s = 0; s < 256; ++s) {
    EXPECT_EQ(table.stretch(s).blocks, 32u);
    EXPECT_EQ(to_double(table.value(s, 0)), 0x1p61);
  }
}

// Levels do not merge into each other. Room for 16 stretches; level one has 3 blocks (1, 2, 3), level two 14 (10 each).
// The 17th block merges: (1 + 2), 3, then 6 pairs of level two and one left over, which it completes.
TEST(ScoreTable, NeighboursOfALevelMerge) {
  static ScoreTable table;
  table.configure(kWarrantNumbers / kFewestStretches, nullptr, nullptr);
  table.begin_level();
  for (int block = 1; block <= 3; ++block) {
    table.current(0) += block;
    table.add_block(static_cast<uint32_t>(32 * block));
  }
  table.begin_level();
  for (int block = 0; block < 14; ++block) {
    table.current(0) += 10;
    table.add_block(0);
  }
  table.flush();
  ASSERT_EQ(table.stretches(), 9);
  EXPECT_EQ(to_double(table.value(0, 0)), 3.0);
  EXPECT_EQ(to_double(table.value(1, 0)), 3.0);
  EXPECT_EQ(table.stretch(1).blocks, 1u);
  EXPECT_EQ(table.stretch(0).level, 1);
  EXPECT_EQ(table.stretch(2).level, 2);
  for (int s = 2; s < 9; ++s) EXPECT_EQ(to_double(table.value(s, 0)), 20.0) << s;
  EXPECT_EQ(table.stretch(0).time, 96u);  // blocks that ended after 32 and 64 samples
}

// Merging goes on sample by sample and has ended when exact sums go into the table again; 445 values are those of 3 DOF and
// 72 probes, 147 stretches. Value v of block b is b + 1000 v, so a stretch from block a to b sums to whole numbers known by hand.
TEST(ScoreTable, AMergeTakesASliceASampleAndLosesNothing) {
  static ScoreTable table;
  constexpr int kValues = 445, kBlocks = 1000;
  const auto in_table = [] {
    uint64_t blocks = 0;
    for (int s = 0; s < table.stretches(); ++s) blocks += table.stretch(s).blocks;
    return blocks;
  };
  table.configure(kValues, nullptr, nullptr);
  table.begin_level();
  int merging = 0, longest_merge = 0;
  for (int block = 0; block < kBlocks; ++block) {
    for (int v = 0; v < kValues; ++v) table.current(v) += block + 1000 * v;
    const bool before = table.merging();
    const uint64_t blocks_before = in_table();
    table.add_block(static_cast<uint32_t>(block));
    if (in_table() != blocks_before) {
      ASSERT_FALSE(before) << "block " << block << " would have had to wait";
    }
    for (int sample = 0; sample < kBlockSamples; ++sample) {
      merging = table.merging() ? merging + 1 : 0;
      longest_merge = std::max(longest_merge, merging);
      table.advance();
    }
  }
  EXPECT_GE(longest_merge, kBlockSamples);  // 73 times 445 additions are not done in a few samples
  table.flush();
  table.settle();
  ASSERT_GT(table.stretches(), 73);
  uint64_t first = 0;
  for (int s = 0; s < table.stretches(); ++s) {
    const uint64_t count = table.stretch(s).blocks, sum = count * first + count * (count - 1) / 2;
    EXPECT_EQ(table.stretch(s).time, sum);
    for (const int v : {0, 1, 444})
      EXPECT_EQ(to_double(table.value(s, v)), static_cast<double>(sum + count * 1000 * static_cast<uint64_t>(v)));
    first += count;
  }
  EXPECT_EQ(first, static_cast<uint64_t>(kBlocks));
}

// One link to the ground with codes at full scale, alternating slowly: everything stays inside its format.
TEST(ProbeForce, FullScaleStaysInItsFormat) {
  static CoreConfiguration c;
  c.dof_count = 1;
  c.link_count = 1;
  c.sample_period_s = Scaled::ratio(1, 1000);
  for (int q = 0; q < kQuantities; ++q) {
    c.channels[0][q].present = true;
    c.channels[0][q].unit_per_code = Scaled::from_int(1, -20);
  }
  copy_measured_signals(c);
  c.term_count = 2;
  c.terms[0].kind = TermKind::kMass;
  c.terms[0].value = Scaled::from_int(3);
  c.terms[1].kind = TermKind::kStiffness;
  c.terms[1].value = Scaled::from_int(1000);
  static BlockMotion block;
  Scaled no_effects[1];
  block.configure(c, no_effects, {});
  static Frame frame;
  for (int q = 0; q < kQuantities; ++q)
    for (int i = 0; i < kFrameStride; ++i) frame.raw[q][i] = (i / 8) % 2 == 0 ? 8388607 : -8388607;
  ASSERT_EQ(block.append(frame, 0, 32), 32);
  ASSERT_FALSE(block.full());
  ASSERT_EQ(block.append(frame, 0, 32), 8);
  ASSERT_TRUE(block.full());
  block.fill_columns();
  // 2^23 codes of 2^-20: 8 units. f - 3 a - 1000 u = -+8024 N; the sum of the full scales is below 2^13 + 2^5.
  for (int i = 0; i < kBlockSamples; ++i) {
    EXPECT_LE(std::abs(block.column(kKnownColumn)[i]), 1 << 27);
    const double force = block.column(kKnownColumn)[i] * to_double(block.column_unit(kKnownColumn));
    EXPECT_NEAR(std::abs(force), 8016.0, 0.01) << i;
  }
  Place place;
  place.kind = PlaceKind::kLink;
  PlaceScale scale;
  for (int q = 0; q < 2; ++q) {
    scale.difference[q] = block.difference(q == 0 ? Quantity::kDisplacement : Quantity::kVelocity, 0, kGroundNode);
    scale.present[q] = true;
    scale.shift[q] = 0;  // codes at full scale are 2^25 in Q26 of the range: beyond 32 units of Q18, clipped there
  }
  static PlaceMotion motion;
  fill_motion(block, place, scale, motion);
  static int32_t phi[kBlockSamples], own[kBlockSamples];
  for (int form = 0; form <= static_cast<int>(Form::kForceRate); ++form) {
    fill_force(static_cast<Form>(form), scale, motion, phi, own);
    for (int i = 0; i < kBlockSamples; ++i) {
      EXPECT_LE(std::abs(phi[i]), 1 << 24) << form;
      EXPECT_LE(std::abs(own[i]), 1 << 24) << form;
    }
  }
}

// A mass of 2^40 kg: at full scale 8 m/s^2 of it are 2^43 N, and the known part counts in 2^17 N. A force of 8 N, full scale of its
// channel, is none of it, of either sign.
TEST(BlockMotion, AForceFarBelowTheKnownTermsIsNothing) {
  static CoreConfiguration c;
  c = CoreConfiguration{};
  c.dof_count = 1;
  c.sample_period_s = Scaled::ratio(1, 1000);
  for (int q = 0; q < kQuantities; ++q) {
    c.channels[0][q].present = true;
    c.channels[0][q].unit_per_code = Scaled::from_int(1, -20);
  }
  copy_measured_signals(c);
  c.term_count = 1;
  c.terms[0].kind = TermKind::kMass;
  c.terms[0].value = Scaled::from_int(1, 40);
  static BlockMotion block;
  Scaled no_effects[1];
  block.configure(c, no_effects, {});
  static Frame frame;
  frame = Frame{};
  for (int i = 0; i < kFrameStride; ++i) frame.raw[0][i] = (i / 8) % 2 == 0 ? 8388607 : -8388607;
  block.append(frame, 0, 32);
  block.append(frame, 0, 32);
  ASSERT_TRUE(block.full());
  block.fill_columns();
  EXPECT_GE(to_double(block.column_unit(kKnownColumn)), 0x1p16);
  for (int i = 0; i < kBlockSamples; ++i) EXPECT_EQ(block.column(kKnownColumn)[i], 0) << i;
}

// u = 1, 2, ... codes: a straight line comes back from its neighbours, its own sample left out.
TEST(BlockMotion, NeighboursGiveAStraightLineBack) {
  static CoreConfiguration c;
  c = CoreConfiguration{};
  c.dof_count = 1;
  c.sample_period_s = Scaled::ratio(1, 1000);
  for (int q = 1; q < kQuantities; ++q) {
    c.channels[0][q].present = true;
    c.channels[0][q].unit_per_code = Scaled::from_int(1);
  }
  copy_measured_signals(c);
  static BlockMotion block;
  Scaled no_effects[1];
  block.configure(c, no_effects, {});
  int32_t x[16];
  for (int i = 0; i < 16; ++i) x[i] = 1000 * i;
  x[8] = 123456;  // the sample itself does not count
  const NodeDifference d = block.difference(Quantity::kDisplacement, 0, kGroundNode);
  const double unit = to_double(Scaled::from_int(1, d.range_exponent - 26));
  EXPECT_NEAR(smoothed(d, between_neighbours_q3(x + 8), 0) * unit, 8000.0, 0.5);
  EXPECT_NEAR(slope(d, x, 8) * unit, 1000.0, 0.5);
  EXPECT_EQ(difference_at(d, x, x, 8) * unit, 123456.0);
}

// v = 1000 n codes: 1000 a sample, times 840 / 2^7 for the acceleration's code, and 8 for Q3. The noise that one sample k gives the
// slope of eight points goes with what it gives the instrument: summed over the samples, nothing.
TEST(Neighbours, ASlopeAndItsInstrumentShareNoNoise) {
  int32_t ramp[16], one[16] = {};
  for (int i = 0; i < 16; ++i) ramp[i] = 1000 * i;
  EXPECT_EQ(slope_840(ramp + 8), 840000);
  EXPECT_NEAR(orthogonal_slope_q3(ramp + 8), 8 * 840000 / 128.0, 1.0);
  double shared = 0, slope_square = 0, instrument_square = 0;
  for (int k = 4; k <= 12; ++k) {
    one[k] = 1 << 20;
    const double of_slope = std::ldexp(static_cast<double>(slope_840(one + 8)), -20),
                 of_instrument = std::ldexp(orthogonal_slope_q3(one + 8), -20);
    shared += of_slope * of_instrument;
    slope_square += of_slope * of_slope;
    instrument_square += of_instrument * of_instrument;
    one[k] = 0;
  }
  EXPECT_NEAR(shared / std::sqrt(slope_square * instrument_square), 0.0, 1e-6);
}

}  // namespace
