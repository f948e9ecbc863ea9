// What a verdict says of faults of sensors, and of drives.
#include <gtest/gtest.h>

#include <string>

#include "host_sim/reports/sections/verdict.hpp"
#include "tests/reports/made_up.hpp"
#include "tests/reports/page_parts.hpp"

namespace {

using namespace host_sim::reports;
using page_parts::contains;

// A sensor is no part of the rig file.
TEST(Verdict, ASensorsFaultIsSaidToBeOne) {
  DiagnosisReportData data;
  data.causes = {{"sensor_delay", "channel force_1_N", 90.0, {}}};
  data.gains = {{1, 60.0, 2.0, 0.0, 0.0}};
  data.verdict = "explained";
  EXPECT_EQ(verdict_sentence(data),
            "A sensor is at fault: sensor delay in channel force_1_N. With this taken into account, the simulation's "
            "error on "
            "unseen data is 30 times smaller.");
  data.causes.push_back({"cubic_stiffness", "link 1-2", 5.0, {}});
  EXPECT_EQ(verdict_headline(data), "The rig file lacks cubic stiffness on link 1-2; a sensor is at fault");
  EXPECT_TRUE(contains(verdict_details(data), "At fault: sensor delay in channel force_1_N."));
  data.causes.resize(1);
  data.verdict = "ambiguous";
  data.ambiguous_with = {{"sensor_delay", "channel displacement_1_m"}};
  EXPECT_EQ(verdict_headline(data), "A sensor is at fault, and these data cannot tell which");
  data.ambiguous_with.push_back({"mass_error", "dof 1"});
  EXPECT_EQ(verdict_headline(data), "The rig file lacks something or a sensor is at fault");
}

// What the drive does not give is told by the force's channel, whose sensor is sound.
TEST(Verdict, ADrivesDeadBandIsNoSensorsFault) {
  DiagnosisReportData data;
  data.causes = {{"drive_dead_band", "channel torque_1_N_m", 90.0, {}}};
  data.verdict = "explained";
  EXPECT_EQ(verdict_headline(data), "The drive is at fault: drive dead band in channel torque_1_N_m");
  data.causes.push_back({"sensor_delay", "channel torque_1_N_m", 5.0, {}});
  EXPECT_EQ(verdict_headline(data),
            "A sensor and the drive are at fault: drive dead band in channel torque_1_N_m and sensor delay in channel "
            "torque_1_N_m");
  data.causes[1] = {"cubic_stiffness", "link 1-0", 5.0, {}};
  EXPECT_EQ(verdict_headline(data), "The rig file lacks cubic stiffness on link 1-0; the drive is at fault");
  data.causes.resize(1);
  data.verdict = "ambiguous";
  data.ambiguous_with = {{"sensor_delay", "channel angle_1_rad"}};
  EXPECT_EQ(verdict_headline(data), "A sensor or a drive is at fault, and these data cannot tell which");
  data.ambiguous_with = {{"mass_error", "dof 1"}};
  EXPECT_EQ(verdict_headline(data), "The rig file lacks something or a drive is at fault");
}

}  // namespace
