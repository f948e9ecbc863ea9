// Every law at a place whose answer fits on a line, and what the table says of itself.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "host_sim/vocabulary/law.hpp"

using namespace vocabulary;

namespace {

struct Hand {
  EffectKind kind;
  double u, w, t_s, shape0, shape1, expected;
};
// u = -2, w = 3 where nothing else is said.
const Hand kHands[] = {
    {EffectKind::kStiffness, -2, 3, 0, 0, 0, -2},
    {EffectKind::kViscous, -2, 3, 0, 0, 0, 3},
    {EffectKind::kCoulomb, -2, -3, 0, 0, 0, -1},
    {EffectKind::kGravityTorque, -1.5707963267948966, 3, 0, 0, 0, -1},  // sin(-90 degrees)
    {EffectKind::kCubicStiffness, -2, 3, 0, 0, 0, -8},
    {EffectKind::kQuadraticStiffness, -2, 3, 0, 0, 0, 4},
    {EffectKind::kBacklash, -2, 3, 0, 0.5, 0, 0.5},      // -clamp(-2, +-0.5)
    {EffectKind::kBacklash, 0.25, 3, 0, 0.5, 0, -0.25},  // inside: all of the spring is gone
    {EffectKind::kEndStop, -2, 3, 0, 0.5, 0, -1.5},      // 1.5 beyond the stop
    {EffectKind::kEndStop, 0.25, 3, 0, 0.5, 0, 0},
    {EffectKind::kQuadraticDamping, -2, -3, 0, 0, 0, -9},
    {EffectKind::kCubicDamping, -2, -3, 0, 0, 0, -27},
    {EffectKind::kStribeck, -2, -3, 0, 3, 0, -0.36787944117144233},  // -exp(-1)
    {EffectKind::kForceOffset, -2, 3, 0, 0, 0, 1},
    {EffectKind::kAsymmetricViscous, -2, -3, 0, 0, 0, 3},
    {EffectKind::kDisplacementDependentDamping, -2, -3, 0, 0, 0, -12},
    {EffectKind::kDriftingViscous, -2, 3, 5, 0, 0, 15},
    {EffectKind::kDriftingViscous, -2, 3, 5, 5, 0, 9.4818083824283644},  // 3 * 5 (1 - exp(-1))
    {EffectKind::kCogging, -2, 3, 0, 8, 0, -1},                          // a quarter of a pitch back
    {EffectKind::kCogging, -2, 3, 0, 4, 1.5707963267948966, -1},         // half a pitch back from the top
    {EffectKind::kMissingGravityTorque, -1.5707963267948966, 3, 0, 0, 0, -1},
    {EffectKind::kDriveDeadBand, -2, 3, 0, 0.5, 0, -0.5},
    {EffectKind::kSensorDelay, -2, 3, 0, 0, 0, -3},
    {EffectKind::kSensorGain, -2, 3, 0, 0, 0, -2},
    {EffectKind::kMainsHum, -2, 3, 0.01, 50, 0, -1},  // half a cycle
    {EffectKind::kSensorOffset, -2, 3, 0, 0, 0, 1},
};

}  // namespace

TEST(Laws, ByHand) {
  for (const Hand& hand : kHands) {
    const Shape shape{{hand.shape0, hand.shape1}};
    EXPECT_NEAR(force(hand.kind, point(hand.kind, hand.u, hand.w, hand.t_s, shape), shape).value, hand.expected, 1e-12)
        << row_of(hand.kind).word.text;
  }
}

// Mass: its own acceleration. Bristles: z, plus tau dz/dt with damped bristles: 0.5 + 0.1 * 2 (1 - 0.5) / 0.2 = 1.
// A hidden mass at 1 Hz without damping, 1 behind its DOF: (2 pi)^2.
TEST(Laws, ThatSeeMoreThanTheRate) {
  Point at;
  at.a = 7.0;
  EXPECT_EQ(force(EffectKind::kMass, at, {}).value, 7.0);
  EXPECT_EQ(force(EffectKind::kMassError, at, {}).value, 7.0);
  at.w = 2.0, at.sign = 1.0, at.z[0] = 0.5;
  EXPECT_NEAR(force(EffectKind::kPreslidingHysteresis, at, {{0.2, 0.0}}).value, 0.5, 1e-15);
  EXPECT_NEAR(force(EffectKind::kPreslidingHysteresis, at, {{0.2, 0.1}}).value, 1.0, 1e-15);
  Point behind;
  behind.u = 1.0;
  EXPECT_NEAR(force(EffectKind::kUnmodelledResonance, behind, {{1.0, 0.3}}).value, 39.478417604357434, 1e-12);
}

TEST(Laws, StartOfMemories) {
  double z[2] = {9, 9};
  start_memory(EffectKind::kPreslidingHysteresis, point(EffectKind::kPreslidingHysteresis, 1, -3, 0, {}), {}, z);
  EXPECT_EQ(z[0], -1.0);
  start_memory(EffectKind::kPreslidingHysteresis, point(EffectKind::kPreslidingHysteresis, 1, 0, 0, {}), {}, z);
  EXPECT_EQ(z[0], 0.0);
  start_memory(EffectKind::kUnmodelledResonance, point(EffectKind::kUnmodelledResonance, 1, -3, 0, {}), {}, z);
  EXPECT_EQ(z[0], 1.0);
  EXPECT_EQ(z[1], -3.0);
}

TEST(Table, EveryFieldSaysSomething) {
  for (const firmware::EffectRow& row : firmware::kEffectTable) {
    SCOPED_TRACE(row.word.text);
    EXPECT_NE(std::string(row.formula.text), "");
    EXPECT_NE(std::string(row.sentence.text), "");
    EXPECT_EQ(row.can.number == 0, row.role == firmware::EffectRole::kOwnTerm);
    if (row.role != firmware::EffectRole::kOwnTerm) {
      EXPECT_NE(std::string(row.experiment.text), "");
    }
    for (int i = 0; i < row.shape.count; ++i) {
      EXPECT_LT(row.shape.at[i].range.low_millionths, row.shape.at[i].range.high_millionths);
      EXPECT_NE(std::string(row.shape.at[i].unit.translating), "");
    }
    EXPECT_EQ(firmware::find_effect(row.word.text), &row);
  }
  EXPECT_EQ(firmware::find_effect("stickiness"), nullptr);
}
