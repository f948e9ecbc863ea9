// What shows while a decay is loud, and not at its quiet end, which the fit has not seen.
#include "tests/hidden_rig/draw.hpp"
#include "two_masses.hpp"

namespace {

// A velocity channel 0.59 ms late beside a displacement and an acceleration of its DOF. The windows of the fit are followed 27 times
// as well (squared) with it; the unseen ones, mostly noise, by the tenth that it is there. "None", it was, with a misfit of 508.
TEST(QuietEnd, ALateChannelIsNoTrifle) {
  hidden_rig::Settings settings;
  settings.condition = "free_decay", settings.sensors = "mixed", settings.hidden = "sensor_delay";
  settings.rho_low = 0.1;
  const hidden_rig::Draw draw = hidden_rig::make_draw(43500001, settings);
  ASSERT_EQ(draw.hidden.size(), 1u);
  const diagnosis::Diagnosis d = diagnosis::diagnose(draw.rig, draw.records, {});
  ASSERT_TRUE(d.names("sensor_delay", draw.hidden[0].where)) << two_masses::said(d);
  const diagnosis::Parameter delay = d.causes[0].parameters.at(0);
  EXPECT_NEAR(delay.value, draw.hidden[0].strength, 4 * delay.std);
}

}  // namespace
