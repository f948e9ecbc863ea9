// How far down a motion reaches, and the corner of the high-pass that follows it up.
#include "hal/rig_file/recorded/slowest_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

#include "hal/rig_file/scaled_double.hpp"
#include "hal/rig_file/signal_plan.hpp"

namespace {

using firmware::CoreConfiguration;
using firmware::Quantity;
using firmware::RawSample;
using Record = std::vector<RawSample>;

constexpr int kA = static_cast<int>(Quantity::kAcceleration), kV = static_cast<int>(Quantity::kVelocity);
constexpr int kMost = 12;

// One DOF, measured by one sensor.
std::unique_ptr<CoreConfiguration> with(int quantity) {
  auto c = std::make_unique<CoreConfiguration>();
  c->dof_count = 1;
  c->channels[0][quantity].present = true;
  return c;
}

// Codes of sines of `slow` and `fast` at rate / 700 and rate / 40, of white noise and a constant.
Record record_of(int quantity, double slow, double fast, double noise, int constant = 0, size_t samples = 20000) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0.0, 1.0);
  Record record(samples);
  for (size_t n = 0; n < samples; ++n) {
    const double turn = 2 * M_PI * static_cast<double>(n);
    record[n].code[0][quantity] = static_cast<int32_t>(
        std::lround(slow * std::sin(turn / 700) + fast * std::sin(turn / 40) + noise * normal(random) + constant));
  }
  return record;
}

int octaves(int quantity, const std::vector<Record>& records, double deviation = 0, double doubt = 0.04) {
  rig_file::NodeNoise noise;
  noise[0][quantity].deviation = deviation, noise[0][quantity].doubt = doubt;
  return rig_file::octaves_to_slowest_motion(*with(quantity), records, noise, kMost);
}

// rate / 40 is between rate / 64 and rate / 32, rate / 700 between rate / 1024 and rate / 512. A velocity is read as it is: 1 % of the
// power is a tenth of the amplitude. An acceleration's velocity is larger by the period: there a tenth is 40 / 700 of a tenth.
TEST(SlowestMotion, IsWhereAHundredthOfTheVelocitysPowerIs) {
  EXPECT_EQ(octaves(kV, {record_of(kV, 0, 1e6, 0)}), 6);
  EXPECT_EQ(octaves(kV, {record_of(kV, 0.07e6, 1e6, 0)}), 6);
  EXPECT_EQ(octaves(kV, {record_of(kV, 0.14e6, 1e6, 0)}), 10);
  EXPECT_EQ(octaves(kA, {record_of(kA, 0.07e6 * 40 / 700, 1e6, 0)}), 6);
  EXPECT_EQ(octaves(kA, {record_of(kA, 0.14e6 * 40 / 700, 1e6, 0)}), 10);
}

// Each record's own motion counts, and one that is weak beside another's too.
TEST(SlowestMotion, IsThatOfTheSlowestRecord) {
  EXPECT_EQ(octaves(kA, {record_of(kA, 0, 1e6, 0), record_of(kA, 1e4, 0, 0)}), 10);
}

// What an accelerometer reads at rest is no motion.
TEST(SlowestMotion, IsNotAConstant) { EXPECT_EQ(octaves(kA, {record_of(kA, 0, 1e6, 0, 4000000)}), 6); }

// White noise of a tenth of the motion has 2 / 20000 * 0.01 / 0.5 of its power in a line. Weighted as velocity from two periods in the
// record, (500 / 2)^2 times as much as the motion's, that is 13 % of it: known, it is taken off, unknown it may be motion.
TEST(SlowestMotion, IsNotKnownNoise) {
  const Record noisy = record_of(kA, 0, 1e6, 0.1e6);
  EXPECT_EQ(octaves(kA, {noisy}, 0.1e6), 6);
  EXPECT_GT(octaves(kA, {noisy}, 0.1e6, 1.0), 6);
}

TEST(SlowestMotion, IsNotSoughtWhereNothingMoves) {
  EXPECT_EQ(octaves(kA, {record_of(kA, 0, 0, 0)}), kMost);
  EXPECT_EQ(octaves(kA, {Record(10)}), kMost);
}

// An accelerometer alone at 10 kHz; friction on the link where asked for.
struct Planned {
  int shift, shift_as_configured;
};
Planned planned(const Record& record, int quantity, bool friction) {
  auto c = with(quantity);
  for (auto& channel : c->channels[0]) channel.unit_per_code = rig_file::to_scaled(std::exp2(-23));
  c->sample_period_s = rig_file::to_scaled(1e-4);
  c->channels[0][static_cast<int>(Quantity::kForce)].present = true;
  c->link_count = 1;
  c->links[0].node_a = 0, c->links[0].node_b = firmware::kGroundNode;
  c->term_count = friction ? 3 : 2;
  c->terms[0].kind = firmware::TermKind::kMass;
  c->terms[1].kind = firmware::TermKind::kStiffness;
  c->terms[2].kind = firmware::TermKind::kCoulomb;
  rig_file::plan_signals(*c);
  const int before = c->high_pass_shift;
  EXPECT_EQ(rig_file::measure_ranges(*c, {record}).octaves_to_slowest_motion, std::nullopt);
  rig_file::plan_signals(*c, rig_file::measure_ranges(*c, {record}, rig_file::Corner::kBelowMotion));
  return {c->high_pass_shift, before};
}

// 10 kHz / (2 pi 1 Hz) is nearest to 2^11. The motion of 250 Hz reaches down to rate / 2^6: half a period of that are 2^5 samples, of which
// 2^6 are the least; a motion of 14.3 Hz reaches down to rate / 2^10: 2^9, with friction 2^10.
TEST(SlowestMotion, TakesTheCornerOfTwoIntegrationsUp) {
  const Record fast = record_of(kA, 0, 1e6, 0), slow = record_of(kA, 1e6, 1e6, 0);
  EXPECT_EQ(planned(fast, kA, false).shift_as_configured, 11);
  EXPECT_EQ(planned(fast, kA, false).shift, 6);
  EXPECT_EQ(planned(slow, kA, false).shift, 9);
  EXPECT_EQ(planned(slow, kA, true).shift, 10);
}

// Of one integration it is 0.5 Hz, 2^12 samples (the most); eight periods of rate / 2^6 are 2^9, of rate / 2^10 2^13: it stays.
TEST(SlowestMotion, LeavesACornerThatTheMotionReaches) {
  EXPECT_EQ(planned(record_of(kV, 0, 1e6, 0), kV, false).shift, 9);
  EXPECT_EQ(planned(record_of(kV, 1e6, 0, 0), kV, false).shift, 12);
}

}  // namespace
