// Delays of more than three sample periods, which no filter of the core reaches over.
#include "host_sim/programs/estimate/long_delays.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "hal/rig_file/channel_entry.hpp"

namespace {

using host_sim::Channel;
using host_sim::Quantity;
using host_sim::Record;
using host_sim::SharedRecords;

// 12 samples 1 ms apart; force 0, 1, 2, ..., displacement 100, 101, 102, ...
SharedRecords records() {
  Record record;
  record.file = "d.csv", record.sample_period_s = 1e-3, record.start_s = 2.0;
  record.channels = {Channel{"force_1_N", Quantity::kForce, 1, {}, 0.0},
                     Channel{"displacement_1_m", Quantity::kDisplacement, 1, {}, 0.0}};
  for (int i = 0; i < 12; ++i) record.channels[0].values.push_back(i), record.channels[1].values.push_back(100 + i);
  return SharedRecords({record});
}

rig_file::RigModel late(const char* channel, double delay_us) {
  rig_file::RigModel model;
  rig_file::entry_to_write(model, channel).delay_us = delay_us;
  return model;
}

// The displacement is 4.3 ms late: of the instant 0 its sample 4 tells, and 0.3 ms are left to the filters. 12 - 4 samples have both.
TEST(LongDelays, AChannelThatIsLateIsReadLater) {
  rig_file::RigModel model = late("displacement_1_m", 4300.0);
  SharedRecords shared = records();
  EXPECT_EQ(host_sim::take_out_long_delays(model, shared),
            "displacement_1_m is read 4 samples later, as the rig file states its delay");
  const Record& record = shared.get().front();
  EXPECT_EQ(record.channels[0].values, (std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(record.channels[1].values, (std::vector<double>{104, 105, 106, 107, 108, 109, 110, 111}));
  EXPECT_NEAR(rig_file::stated_delay_s(model, "displacement_1_m"), 0.3e-3, 1e-12);
  EXPECT_EQ(record.start_s, 2.0);
}

// The force is 4.7 ms early, five samples: the first instant that has one is that of sample 5, 5 ms after the start.
TEST(LongDelays, AChannelThatIsEarlyIsReadEarlier) {
  rig_file::RigModel model = late("force_1_N", -4700.0);
  SharedRecords shared = records();
  EXPECT_EQ(host_sim::take_out_long_delays(model, shared),
            "force_1_N is read 5 samples earlier, as the rig file states its delay");
  const Record& record = shared.get().front();
  EXPECT_EQ(record.channels[0].values, (std::vector<double>{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(record.channels[1].values, (std::vector<double>{105, 106, 107, 108, 109, 110, 111}));
  EXPECT_NEAR(rig_file::stated_delay_s(model, "force_1_N"), 0.3e-3, 1e-12);
  EXPECT_NEAR(record.start_s, 2.005, 1e-12);
  EXPECT_EQ(record.left_out_before, 5u);
}

TEST(LongDelays, WhatTheFiltersTakeStaysWithThem) {
  for (const double delay_us : {0.0, 2900.0, -2900.0}) {
    rig_file::RigModel model = late("force_1_N", delay_us);
    SharedRecords shared = records();
    EXPECT_EQ(host_sim::take_out_long_delays(model, shared), "");
    EXPECT_EQ(shared.get().front().samples(), 12u);
    EXPECT_EQ(rig_file::stated_delay_s(model, "force_1_N"), 1e-6 * delay_us);
  }
}

TEST(LongDelays, ARecordThatIsShorterIsRefused) {
  rig_file::RigModel model = late("force_1_N", 11000.0);
  SharedRecords shared = records();
  EXPECT_THROW(host_sim::take_out_long_delays(model, shared), std::runtime_error);
}

}  // namespace
