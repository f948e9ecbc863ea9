// A force that is held, or drawn straight, between its samples is no fault of the sensors; a fault of a sensor is no hold.
#include <gtest/gtest.h>

#include "judgement.hpp"

namespace hidden {
namespace {

void expect_told(Drive drive, const std::string& word) {
  Settings none, one;
  none.hide = Hide::kNothing, one.hide = Hide::kOne;
  none.drive = one.drive = drive, one.rho_low = 0.2;
  for (uint64_t seed : {1, 2, 3}) {
    const Draw clean = make_draw(seed, none), bent = make_draw(seed, one);
    const diagnosis::Diagnosis to_clean = answer_to(clean), to_bent = answer_to(bent);
    EXPECT_EQ(judge(clean, to_clean), Outcome::kExact) << told(clean, to_clean);
    EXPECT_NE(judge(bent, to_bent), Outcome::kWrong) << told(bent, to_bent);
    EXPECT_EQ(to_clean.force_between_samples, word);
    EXPECT_EQ(to_bent.force_between_samples, word);
    EXPECT_NEAR(to_clean.baseline_misfit, 1, 0.2);
  }
}

TEST(DriveHold, SmoothForce) { expect_told(Drive::kSmooth, "smooth"); }
TEST(DriveHold, ForceStraightBetweenSamples) { expect_told(Drive::kLinear, "linear"); }
TEST(DriveHold, ForceHeldUntilTheNextSample) { expect_told(Drive::kSteps, "steps"); }

// One channel of motion does not show what folds back, but a held force is half a sample late and a straight one weaker at
// high frequencies: neither is a fault of the force sensor where the hold explains it.
TEST(DriveHold, OneChannelOfMotionIsEnoughToSpareTheForceSensor) {
  struct Case {
    const char* sensors;
    double noise;
    Drive drive;
    const char* word;
  };
  for (const Case& c : {Case{"x", 0.01, Drive::kSteps, "steps"}, Case{"a", 0.002, Drive::kLinear, "linear"}}) {
    Settings none;
    none.hide = Hide::kNothing, none.sensors = c.sensors, none.noise = c.noise, none.drive = c.drive;
    for (uint64_t seed : {1, 2, 3}) {
      const Draw draw = make_draw(seed, none);
      const diagnosis::Diagnosis answer = answer_to(draw);
      EXPECT_EQ(judge(draw, answer), Outcome::kExact) << c.sensors << " " << c.word << " " << told(draw, answer);
      EXPECT_EQ(answer.force_between_samples, c.word) << c.sensors << " seed " << seed;
    }
  }
}

double least_delay_of_force_s(const diagnosis::Diagnosis& answer) {
  for (const diagnosis::DetectionLimit& l : answer.minimum_detectable)
    if (l.effect == "sensor_delay" && l.where == "channel force_1_N") return l.strength;
  return 0;
}

// Steps come half a sample late on average. How much of that was taken out rests on a mass that the folded motion shows to
// half a percent or so: 0.005 * 0.5 ms = 2.5 us, below which no delay of the force is told from it.
TEST(DriveHold, ADelayThatTheHoldWouldExplainIsNotNamed) {
  Settings none;
  none.hide = Hide::kNothing, none.dofs = 1;
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    none.drive = Drive::kSteps;
    const diagnosis::Diagnosis held = answer_to(make_draw(seed, none));
    for (const diagnosis::Cause& c : held.causes) EXPECT_NE(c.effect, "sensor_delay") << "seed " << seed;
    if (held.verdict != diagnosis::Verdict::kNone || seed > 3) continue;
    // the free runs simulate the steps and have no such doubt: the limit is theirs where it is the larger one
    none.drive = Drive::kSmooth;
    EXPECT_GT(least_delay_of_force_s(held), 2.5e-6) << "seed " << seed;
    EXPECT_GT(least_delay_of_force_s(held), least_delay_of_force_s(answer_to(make_draw(seed, none))))
        << "seed " << seed;
  }
}

TEST(DriveHold, AFaultOfASensorIsNoHold) {
  Settings settings;
  settings.hide = Hide::kSensorFault, settings.rho_low = 0.02, settings.rho_high = 0.1;
  for (const char* kind : {"sensor_delay", "sensor_gain"})
    for (uint64_t seed : {1, 2, 3, 4}) {
      settings.kind = kind;
      const Draw draw = make_draw(seed, settings);
      const diagnosis::Diagnosis answer = answer_to(draw);
      EXPECT_EQ(answer.force_between_samples, "smooth") << told(draw, answer);
      EXPECT_NE(judge(draw, answer), Outcome::kWrong) << told(draw, answer);
    }
}

}  // namespace
}  // namespace hidden
