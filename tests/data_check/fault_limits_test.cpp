// What looks like a fault and is none, and faults that only other records or motions tell.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "host_sim/data_check/flat/clipping.hpp"
#include "tests/data_check/faults.hpp"

namespace {

using faults::all_of;
using faults::find;
using faults::Finding;
using faults::kA1;
using faults::kX1;
using faults::Record;
using faults::Report;
using faults::Weight;
using faults::with;
using host_sim::data_check::check;
using host_sim::data_check::find_clipping;
using host_sim::data_check::statistics_of;

// Late by 2 ms: nothing beyond what the rig file states, 1 ms beyond half of it.
TEST(Faults, ADelayThatTheRigFileStatesIsNotTold) {
  Record record = made::record(with("xa"));
  std::vector<double>& a = made::values(record, kA1);
  std::rotate(a.begin(), a.end() - 2, a.end());
  rig_file::RigModel rig = made::chain();
  rig.channels.emplace_back();
  rig.channels.back().name = kA1;
  rig.channels.back().delay_us = 2000;
  const Report stated = check({record}, &rig);
  EXPECT_EQ(find(stated, "skew", kA1), nullptr) << all_of(stated);
  rig.channels.back().delay_us = 1000;
  const Report half = check({record}, &rig);
  const Finding* finding = find(half, "skew", kA1);
  ASSERT_NE(finding, nullptr) << all_of(half);
  EXPECT_NEAR(*finding->value, 1e-3, 1e-4);
}

// A force sensor that is dead while the shaker shakes: the motion grows again and again.
TEST(Faults, ADeadForceIsSeenByMotionThatGrows) {
  made::Options options;
  options.drive = made::Drive::kHammer;
  Record record = made::record(options);
  for (double& value : made::values(record, "force_1_N")) value = 0.0;
  const rig_file::RigModel rig = made::chain();
  const Report report = check({record}, &rig);
  const Finding* finding = find(report, "dead", "force_1_N");
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->weight, Weight::kFault) << finding->detail;
}

// The chain's cables were exchanged in one of two records only: nobody does that between two runs.
TEST(Faults, AnExchangeInOneRecordOfTwoIsNone) {
  Record good = made::record(with("x")), bad = made::record(with("x"));
  std::swap(made::values(bad, kX1), made::values(bad, "displacement_2_m"));
  const rig_file::RigModel rig = made::chain();
  EXPECT_NE(find(check({bad, bad}, &rig), "exchanged", kX1), nullptr);
  EXPECT_EQ(find(check({good, bad}, &rig), "exchanged", kX1), nullptr);
}

// A motor that rests before its step: its angle and speed stay at their lowest value, whose noise shows later. A stop in
// the middle of the record, into which the angle runs at full speed, is one.
TEST(Faults, ARigThatRestsBeforeItsDriveIsNotClipped) {
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0.0, 1e-3);
  host_sim::Channel angle{"angle_1_rad", host_sim::Quantity::kDisplacement, 1, {}};
  host_sim::Channel speed{"angular_velocity_1_rad_s", host_sim::Quantity::kVelocity, 1, {}};
  for (int i = 0; i < 2000; ++i) {
    const double t = std::max(0.0, 0.002 * (i - 200)), w = 20 * (1 - std::exp(-t / 0.1));
    angle.values.push_back(t > 0 ? 20 * (t - 0.1 * (1 - std::exp(-t / 0.1))) + noise(random) : 0.0);
    speed.values.push_back(t > 0 ? w + 30 * noise(random) : 0.0);
  }
  for (const host_sim::Channel& channel : {angle, speed}) {
    EXPECT_FALSE(find_clipping(channel, statistics_of(channel), 0, 0)) << channel.name;
    host_sim::Channel backwards = channel;  // and rests at its end
    std::reverse(backwards.values.begin(), backwards.values.end());
    EXPECT_FALSE(find_clipping(backwards, statistics_of(backwards), 0, 0)) << channel.name;
  }
  for (double& value : angle.values) value = std::min(value, 60.0);
  for (int i = 0; i < 500; ++i) angle.values.push_back(60.0 - 0.04 * i + noise(random));
  const auto found = find_clipping(angle, statistics_of(angle), 0, 0);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, "clipped");
}

}  // namespace
