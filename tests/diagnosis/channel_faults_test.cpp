// Faults of channels that no second channel bears out: the rig's equations alone show them.
#include <gtest/gtest.h>

#include "judgement.hpp"

namespace hidden {
namespace {

diagnosis::Diagnosis answer_to(const Draw& draw) { return diagnosis::diagnose(draw.rig, {draw.record}, {}); }

Settings fault(const char* kind, const char* channel, const char* sensors, double rho) {
  Settings s;
  s.hide = Hide::kSensorFault, s.kind = kind, s.channel = channel, s.sensors = sensors;
  s.rho_low = s.rho_high = rho;
  return s;
}

// rho is a hundredth of a second for delays: 0.5, 1.5 and 4 ms, at 50 Hz up to 1.3 rad, where the first order is far off.
// At 1 % noise the limit is some 10 us: 3 % of 0.5 ms are 15 us.
TEST(ChannelFaults, ADelayOfTheForceIsNamedAndMeasuredHoweverLong) {
  for (const char* sensors : {"xva", "x", "a"})
    for (double rho : {0.05, 0.15, 0.4})
      for (uint64_t seed : {31, 32}) {
        Settings s = fault("sensor_delay", "force_1_N", sensors, rho);
        s.dofs = 2;
        const Draw draw = make_draw(seed, s);
        const diagnosis::Diagnosis answer = answer_to(draw);
        ASSERT_EQ(judge(draw, answer), Outcome::kExact) << sensors << " " << told(draw, answer);
        EXPECT_NEAR(answer.causes[0].parameters[0].value / draw.truth[0].strength, 1, 0.03) << sensors << " seed " << seed;
        const double least_gain = sensors[0] == 'x' ? 2 : 1;  // what is integrated has noise of its own
        EXPECT_GT(answer.gain[0], least_gain) << sensors << " rho " << rho << " seed " << seed;
      }
}

// The simulation of unseen data is driven by the force as corrected: a gain error of 5 % leaves 5 % of the motion wrong, of
// which the corrected force leaves the noise, 1 %.
TEST(ChannelFaults, AGainOfTheForceIsTakenOutOfTheSimulation) {
  for (uint64_t seed : {31, 32, 33}) {
    Settings s = fault("sensor_gain", "force_1_N", "x", 0.05);
    s.dofs = 2;
    const Draw draw = make_draw(seed, s);
    const diagnosis::Diagnosis answer = answer_to(draw);
    ASSERT_EQ(judge(draw, answer), Outcome::kExact) << told(draw, answer);
    EXPECT_NEAR(answer.causes[0].parameters[0].value, draw.truth[0].strength, 0.003) << "seed " << seed;
    EXPECT_GT(answer.gain[0], 2) << "seed " << seed;
  }
}

}  // namespace
}  // namespace hidden
