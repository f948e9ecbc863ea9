// A cause that the rows of the equations have no column for, and the one that looks like it there.
#include <gtest/gtest.h>

#include "tests/hidden_rig/draw.hpp"
#include "two_masses.hpp"

namespace {

// rms of the hidden force: 0.1 to 0.6 of the damping force of its link.
std::string answer_to(uint64_t seed, const char* condition, const char* sensors, const char* hidden) {
  hidden_rig::Settings settings;
  settings.condition = condition, settings.sensors = sensors, settings.hidden = hidden, settings.rho_low = 0.1;
  const hidden_rig::Draw draw = hidden_rig::make_draw(seed, settings);
  return two_masses::said(diagnosis::diagnose(draw.rig, draw.records, {}));
}

// Where small forces do not come through, the force reads too large: so the rows have it, and its gain leaves them noise alone.
TEST(RowsOutdone, ADeadBandIsNoGain) {
  EXPECT_EQ(answer_to(9200006, "seconds_2", "x", "drive_dead_band"), "explained, drive_dead_band on channel force_1_N");
}

// Of two causes of the rows (a gain and a quadratic damping) neither is there.
TEST(RowsOutdone, ADeadBandIsNotTwoCausesEither) {
  EXPECT_EQ(answer_to(5600006, "random_5pct", "xa", "drive_dead_band"),
            "explained, drive_dead_band on channel force_1_N");
}

TEST(RowsOutdone, AGainIsNoDeadBand) {
  for (const char* sensors : {"x", "v"})
    EXPECT_EQ(answer_to(9200006, "seconds_2", sensors, "sensor_gain"), "explained, sensor_gain on channel force_1_N");
}

}  // namespace
