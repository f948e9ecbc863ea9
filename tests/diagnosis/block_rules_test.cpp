// What blocks of a record say together: significance, gains paired over them, noise that knows how loud the motion
// is, windows that are kept apart; and two estimates of one number. Answers are worked out by hand beside each.
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/diagnosis/answer/answer.hpp"
#include "host_sim/diagnosis/numbers/numbers_of.hpp"
#include "host_sim/diagnosis/residual/with_motion.hpp"
#include "host_sim/diagnosis/trial/paired.hpp"

namespace {

using namespace diagnosis::runs;
using diagnosis::Kind;

// 8 windows of 8 blocks; one coefficient of 2 with the normal matrix 1 in each block, and what is left pulls by +3
// over so many blocks, by -3 over the next.
Fitted pulled(int blocks, double memory) {
  Fitted f;
  f.ok = true, f.parts = 8, f.block_length = 100, f.memory = memory;
  for (int b = 0; b < 64; ++b) {
    f.gram.push_back(Mat::Ones(1, 1));
    f.score.push_back(Vec::Constant(1, (b / blocks) % 2 ? -3.0 : 3.0));
    f.block_ss.push_back(Vec::Ones(1));
  }
  return f;
}

Model one_damper(double value) {
  ModelTerm t;
  t.term = diagnosis::on_link(Kind::kViscous, 0), t.value = value, t.known = false;
  return {t};
}

// One by one each block's influence is 3 / 64 / (1 - 1 / 64) = 0.0476, of 64 blocks together 0.381: t = 5.25. What is
// left resembles itself over 70 samples: blocks of 100 are taken 8 by 8, 24 / 64 / (1 - 1 / 8) = 0.429, of 8 together
// 1.212: t = 1.65. The same where all of it hardly resembles itself, and what pulls goes through whole windows (a
// resonance in much noise).
TEST(Blocks, AreAsLongAsWhatIsLeftIsRemembered) {
  const Model model = one_damper(2);
  const double white = determined(pulled(1, 1), model)[0].z;
  const double coloured = determined(pulled(8, 70), model)[0].z;
  EXPECT_NEAR(white, normal_deviate(2 / 0.381, 64), 0.02);
  EXPECT_NEAR(coloured, normal_deviate(2 / 1.212, 8), 0.02);
  EXPECT_NEAR(determined(pulled(8, 1), model)[0].z, normal_deviate(2 / 1.212, 8), 0.02);
  EXPECT_GT(white, 4.5);
  EXPECT_LT(coloured, 2);
}

// One window, whose error lasts over all of it: as one block all 192 parts pull by nought, which is where a fit ends. A damper, and beside it
// a friction or a shape that goes with it by 0.9: what pulls is +3 over 8 parts, -3 over the next 8, on the damper alone.
Fitted lasting() {
  Fitted f;
  f.ok = true, f.parts = 192, f.block_length = 1, f.memory = 50;
  for (int b = 0; b < 192; ++b) {
    f.gram.push_back((Mat(2, 2) << 1, 0.9, 0.9, 1).finished());
    f.score.push_back((Vec(2) << ((b / 8) % 2 ? -3.0 : 3.0), 0).finished());
    f.block_ss.push_back(Vec::Ones(1));
  }
  return f;
}

// Beside the friction 24 blocks have an influence of 24 / 192 / 0.19 / (1 - 1 / 24) = 0.687 each, together 3.36; Student's law of 24 makes
// 3.54 of it. It was nought: the scatter of one block. At a given shape, which alone is not determined, 8 blocks
// have 24 / 192 / (1 - 1 / 8) = 0.143 each, together 0.404, Student's law of 8 makes 0.475.
TEST(Blocks, AnIntervalAllowsForWhatGoesWithItsNumber) {
  Model beside = one_damper(2), shaped = beside;
  beside.push_back(beside[0]), beside[1].term.kind = Kind::kMissingCoulomb;
  shaped[0].term.kind = Kind::kStribeck, shaped[0].term.shape = 1, shaped[0].shape_free = true;
  EXPECT_NEAR(determined(lasting(), beside)[0].std, 3.54, 0.02);
  EXPECT_NEAR(determined(lasting(), shaped)[0].std, 0.475, 0.005);
}

// 24 blocks of 8 parts; the first is a thousand times as loud. A model leaves a tenth of each, a fifth more or less.
Fitted swept(double left) {
  Fitted f;
  f.ok = true, f.mean_square = Vec::Ones(1);
  for (size_t b = 0; b < kBlocks * kFiner; ++b) {
    const size_t block = b / kFiner;
    const double loud = block == 0 ? 1000 : 1, change = left < 1 ? (block % 2 ? 1.2 : 0.8) : 1;
    f.block_ss.push_back(Vec::Constant(1, loud * left * change));
  }
  return f;
}

// Differences: 900 once and 0.9 else, so that mean over standard error is about 1. Logarithms: 2.3 +- 0.2 everywhere.
TEST(Blocks, OneLoudBlockDoesNotHideWhatAllOthersShow) {
  EXPECT_LT(paired_z(swept(1), swept(0.1)), 1.5);
  EXPECT_GT(paired_share_z(swept(1), swept(0.1)), 6);
  EXPECT_NEAR(paired_share_z(swept(1), swept(1)), 0, 1e-9);
}

Prepared shaken(Index samples, double loud_until, double then) {
  Prepared p;
  p.step_s = 0.01, p.samples = samples, p.period_s = 0.5, p.top_Hz = 4;
  p.guess.resize(2);
  Vec x(samples);
  for (Index k = 0; k < samples; ++k)
    x[k] = (static_cast<double>(k) < loud_until * static_cast<double>(samples) ? 1 : then) *
           std::sin(12.566370614359172 * 0.01 * static_cast<double>(k));
  p.guess[0] = {true, x, x, x};
  p.traces.push_back({0, 0, "displacement_1_m", x});
  p.force = {Vec::Ones(samples)};
  return p;
}

// A sweep that has left the resonance: its last 30 % show little of what the resonance did.
TEST(Blocks, WindowsThatAreKeptApartMoveAsTheOthersDo) {
  const auto kept_early = [](const Prepared& p) {
    size_t early = 0, unseen = 0;
    for (const Window& w : lay_windows({p}, 4, 0.3, false))
      if (w.unseen) ++unseen, early += w.from < 2800;
    EXPECT_GT(unseen, 4u);
    return early;
  };
  EXPECT_EQ(kept_early(shaken(4000, 1, 1)), 0u);
  EXPECT_GT(kept_early(shaken(4000, 0.7, 0.1)), 3u);
}

// 24 windows, loud and quiet in turn. An error that is a hundredth of the motion's square is none of a sensor; one
// that is the same in all may be.
WithLoudness told_of(bool grows) {
  const Index length = 100;
  const Prepared p = shaken(24 * length, 1, 1);
  std::vector<Prepared> records{p};
  State s;
  s.fit.ok = true, s.fit.parts = 1, s.fit.mean_square = Vec::Ones(1);
  for (Index i = 0; i < 24; ++i) {
    const double loud = i % 2 ? 1 : 0.2, jitter = 1 + 0.1 * std::sin(static_cast<double>(7 * i));
    records[0].traces[0].y.segment(i * length, length) *= loud;
    Window w;
    w.from = i * length, w.length = length;
    s.seen.push_back(w);
    s.fit.block_ss.push_back(Vec::Constant(1, (grows ? 0.01 * loud * loud : 0.01) * jitter));
  }
  return with_loudness(records, s);
}

// The quieter quarter leaves 0.04 of the louder half: of the mean of both 0.04 / 0.52 = 0.077.
TEST(Blocks, AnErrorThatGrowsWithTheMotionIsNoNoise) {
  EXPECT_GT(told_of(true).z, 3);
  EXPECT_NEAR(told_of(true).quiet_share, 0.077, 0.01);
  EXPECT_LT(std::abs(told_of(false).z), 3);
  EXPECT_NEAR(told_of(false).quiet_share, 1, 0.12);
}

// Of 10 +- 0.1 and 10.2 +- 0.2 the first stands with the wider interval: 0.2 apart where 0.22 is one standard error.
// 12 +- 0.2 contradicts: then all numbers are those of the runs, as those of one fit belong together; but a sensor's delay stays.
TEST(Numbers, OfTheRunsStandTogetherWhereOneContradictsTheRows) {
  const auto number = [](const char* name, double value, double std) {
    return diagnosis::Parameter{name, value, "1", std, true};
  };
  const std::vector<diagnosis::Parameter> runs = {number("viscous[1-0]", 10.2, 0.2), number("stribeck[1-0]", 12, 0.2),
                                                  number("stribeck_velocity[1-0]", 0.3, 0),
                                                  number("sensor_delay[1]", 2, 0.2)};
  std::vector<diagnosis::Parameter> rows = {number("viscous[1-0]", 10, 0.1), number("stribeck[1-0]", 10, 0.1),
                                            number("stribeck_velocity[1-0]", 0.1, 0),
                                            number("sensor_delay[1]", 1, 0.1)};
  std::vector<diagnosis::Parameter> widened = rows;
  take_numbers(runs, true, rows), take_numbers(runs, false, widened);
  EXPECT_FALSE(contradicts(widened[0], runs[0]));
  EXPECT_TRUE(contradicts(number("stribeck[1-0]", 10, 0.1), runs[1]));
  EXPECT_DOUBLE_EQ(rows[0].value, 10.2);
  EXPECT_DOUBLE_EQ(rows[0].std, 0.2);
  EXPECT_DOUBLE_EQ(widened[0].value, 10);
  EXPECT_DOUBLE_EQ(widened[0].std, 0.2);
  EXPECT_DOUBLE_EQ(rows[1].value, 12);
  EXPECT_DOUBLE_EQ(rows[1].std, 0.2);
  EXPECT_DOUBLE_EQ(rows[2].value, 0.3);
  EXPECT_DOUBLE_EQ(rows[3].value, 1);
  EXPECT_DOUBLE_EQ(widened[1].value, 10);
  EXPECT_DOUBLE_EQ(widened[1].std, 0.2);
}

}  // namespace
