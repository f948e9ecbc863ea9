// A fault that the channels of a DOF show among themselves needs no model of the rig: no effect of the rig stands in its place, and
// what it leaves to the channels beside it is no fault of theirs. Hammer, displacement, velocity and acceleration of every DOF.
#include <gtest/gtest.h>

#include "tests/hidden_rig/draw.hpp"
#include "two_masses.hpp"

namespace {

diagnosis::Diagnosis answer_to(uint64_t seed, const char* fault) {
  hidden_rig::Settings settings;
  settings.condition = "hammer", settings.sensors = "xva", settings.hidden = fault;
  const hidden_rig::Draw draw = hidden_rig::make_draw(seed, settings);
  return diagnosis::diagnose(draw.rig, draw.records, {});
}

void expect_alone(const diagnosis::Diagnosis& d, const char* effect, const char* channel) {
  ASSERT_EQ(d.causes.size(), 1u) << two_masses::said(d);
  EXPECT_EQ(d.causes[0].effect, effect);
  EXPECT_EQ(d.causes[0].where, channel);
  EXPECT_TRUE(d.ambiguous_with.empty()) << d.ambiguous_with[0].effect << " on " << d.ambiguous_with[0].where;
}

// 1 ms late in blows that reach 200 Hz: a fifth of a turn there is no small delay, and what its slope misses looks like gains of a part in a
// thousand of the other two.
TEST(FaultRivals, ALargeDelayIsNotLostForWhatItLeavesToOthers) {
  expect_alone(answer_to(28200002, "sensor_delay"), "sensor_delay", "channel velocity_2_m_s");
}

TEST(FaultRivals, NoEffectOfTheRigStandsForADelayOrAGain) {
  expect_alone(answer_to(28200003, "sensor_delay"), "sensor_delay", "channel displacement_2_m");
  expect_alone(answer_to(28200002, "sensor_gain"), "sensor_gain", "channel velocity_2_m_s");
}

}  // namespace
