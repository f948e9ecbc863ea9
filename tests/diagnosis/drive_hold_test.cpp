// A force that is held, or drawn straight, between its samples is no fault of the sensors; a fault of a sensor is no hold.
#include <gtest/gtest.h>

#include "judgement.hpp"

namespace hidden {
namespace {

diagnosis::Diagnosis answer_to(const Draw& draw) { return diagnosis::diagnose(draw.rig, {draw.record}, {}); }

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
