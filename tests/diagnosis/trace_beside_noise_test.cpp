// What the equations' rows see beside noise and no effect of the vocabulary makes: the rig file does not explain it.
#include <gtest/gtest.h>

#include "draw.hpp"
#include "host_sim/diagnosis/residual/lines.hpp"
#include "tests/hidden_rig/draw.hpp"
#include "two_masses.hpp"

namespace {

// 5 % of noise in every channel; rms of the hidden force 0.05 to 0.18 of the damping force.
diagnosis::Diagnosis answer_to(uint64_t seed, hidden::Hide hide) {
  hidden::Settings settings;
  settings.hide = hide, settings.noise = 0.05, settings.rho_low = 0.05, settings.rho_high = 0.18;
  const hidden::Draw draw = hidden::make_draw(seed, settings);
  return diagnosis::diagnose(draw.rig, {draw.record}, {});
}

// A foreign tone of 0.053 of the damping force moves no channel beyond a tenth of its noise.
TEST(TraceBesideNoise, IsUnknown) {
  const diagnosis::Diagnosis d = answer_to(8600004, hidden::Hide::kOutside);
  EXPECT_EQ(two_masses::said(d), "unknown");
  EXPECT_NE(d.unknown_trace.find("tone of 21.8 Hz"), std::string::npos) << d.unknown_trace;
  EXPECT_FALSE(d.noise_hides());
}

TEST(TraceBesideNoise, IsNotThereWhereNothingIsHidden) {
  EXPECT_EQ(two_masses::said(answer_to(8600004, hidden::Hide::kNothing)), "none");
}

// Driven by sines, friction repeats with them: what the rows round of it near reversals is a tone of an odd multiple. Runs do not round
// it, and leave none.
TEST(TraceBesideNoise, RoundedFrictionIsNoTone) {
  struct Case {
    const char *condition, *sensors;
    uint64_t seed;
  };
  for (const Case& c : {Case{"stepped_sine", "xva", 16850001}, Case{"sine_records", "v", 16950004}}) {
    hidden_rig::Settings settings;
    settings.condition = c.condition, settings.sensors = c.sensors;
    const hidden_rig::Draw draw = hidden_rig::make_draw(c.seed, settings);
    EXPECT_EQ(two_masses::said(diagnosis::diagnose(draw.rig, draw.records, {})), "none") << c.condition;
  }
}

// The mains are in the room, not in the rig: 49.95 Hz too, and 119.9 Hz, in bins of 0.05 Hz.
TEST(TraceBesideNoise, IsNoHum) {
  for (const double hertz : {50.0, 49.95, 119.9}) EXPECT_TRUE(diagnosis::runs::of_mains(hertz, 0.05)) << hertz;
  for (const double hertz : {49.5, 55.0, 21.8}) EXPECT_FALSE(diagnosis::runs::of_mains(hertz, 0.05)) << hertz;
}

// A sweep of displacements: what the rows' rates miss near reversals of friction looks like a force that repeats with the elongation, on a
// way that holds one and a half of its pitches hardly once. In the runs no such force is beyond chance.
TEST(TraceBesideNoise, RoundedFrictionOnAShortWayIsNoPitch) {
  hidden_rig::Settings settings;
  settings.condition = "log_sweep", settings.sensors = "x";
  const hidden_rig::Draw draw = hidden_rig::make_draw(17050001, settings);
  const diagnosis::Diagnosis d = diagnosis::diagnose(draw.rig, draw.records, {});
  EXPECT_EQ(two_masses::said(d), "none") << d.unknown_trace;
}

}  // namespace
