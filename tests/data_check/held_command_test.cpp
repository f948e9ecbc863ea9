// A command that never changes drives the rig all the same.
#include <gtest/gtest.h>

#include "host_sim/data_check/drive/excitation.hpp"
#include "host_sim/data_check/flat/dead.hpp"
#include "host_sim/data_check/measures/statistics.hpp"
#include "tests/data_check/made_records.hpp"

namespace {

using namespace host_sim::data_check;

host_sim::Record stepped(double force_N, bool held) {
  host_sim::Record record = made::record({made::Drive::kDecay, "xv"});
  const std::vector<double> force(record.samples(), force_N);
  record.channels.insert(record.channels.begin(), {"force_1_N", host_sim::Quantity::kForce, 1, force, 0.0, held});
  return record;
}

TEST(HeldCommand, IsAConstantForce) {
  const host_sim::Record record = stepped(5.0, true);
  const Drive drive = drive_of(record);
  EXPECT_EQ(drive.channel, "force_1_N");
  EXPECT_EQ(drive.constant, 5.0);
  EXPECT_NE(describe_excitation({record}, {drive}).at(0).detail.find("force_1_N: a constant 5 N"), std::string::npos);
  EXPECT_NE(find_dead(record, std::vector<bool>(record.channels.size())).at(0)->detail.find("as a constant force"),
            std::string::npos);
}

TEST(HeldCommand, OfNoughtIsNone) { EXPECT_EQ(drive_of(stepped(0.0, true)).channel, ""); }

TEST(HeldCommand, ASensorThatNeverChangesIsNone) {
  const host_sim::Record record = stepped(5.0, false);
  EXPECT_EQ(drive_of(record).channel, "");
  EXPECT_NE(find_dead(record, std::vector<bool>(record.channels.size())).at(0)->detail.find("as a free decay"),
            std::string::npos);
}

// The mean of a thousand times 0.1 is 0.1 but for its rounding: that is no level.
TEST(HeldCommand, AConstantHasNoRms) {
  EXPECT_EQ(mean_and_rms(std::vector<double>(1000, 0.1)).rms, 0.0);
  EXPECT_EQ(mean_and_rms(std::vector<double>(1000, 0.1)).mean, 0.1);
}

}  // namespace
