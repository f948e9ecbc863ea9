// What a rig sends, counted by hand. A classic frame of n bytes takes 47 + 8 n bits and a stuff bit for every four of
// the 34 + 8 n - 1 that may be stuffed: 8 bytes 135, 7 bytes 125, 5 bytes 105, 1 byte 65 bits.
#include "firmware/can_protocol/load/bus_plan.hpp"

#include <gtest/gtest.h>

#include "firmware/can_protocol/frame_table.hpp"

namespace {

using namespace firmware;

// The paper's rig: force on DOF 1, displacement and velocity of each DOF.
SensorPlan three_dofs(SensorWiring wiring) {
  CoreConfiguration configuration;
  configuration.dof_count = 3;
  configuration.channels[0][0].present = true;
  for (int dof = 0; dof < 3; ++dof)
    configuration.channels[dof][1].present = configuration.channels[dof][2].present = true;
  return sensor_plan(configuration, wiring);
}

BusTraffic traffic(const SensorPlan& sensors) {
  BusTraffic result;
  result.sensors = &sensors;
  result.drive_on_can = true;
  result.unknowns = 5;
  result.channels = 7;
  return result;
}

TEST(BusPlan, ThreeDofsOnClassicCanByHand) {
  // Each ms: 3 motion and 1 force frame of 8 bytes and a drive command of 7: 4 * 135 + 125 = 665 bits; at 500 kbit/s 133 %.
  // Reports each second: window 135, 5 estimates 675, 10 heartbeats 650, 10 states 1350, health, bus health, identity,
  // diagnosis 540, its size 135 and rival of 6 bytes 115, 5 parameters of 6 bytes 5 * 115 = 575; each 5 s 7 scalings 945
  // and 7 ranges of 7 bytes 875, a fifth: 364. In all 4539 bits each second: 9.1 per mille at 500 kbit/s.
  const SensorPlan sensors = three_dofs(SensorWiring::k24);
  const BusPlan plan = bus_plan(traffic(sensors));
  int64_t each_sample = 0;
  for (int i = 0; i < plan.count; ++i)
    if (plan.streams[i].period_ns == 1000000) each_sample += load_permille(plan.streams[i], {500000, 2000000});
  EXPECT_EQ(each_sample, 1330);
  EXPECT_EQ(load_permille(plan, {500000, 2000000}), 1330 + 10);
  // At 1 Mbit/s half of it: it fits.
  EXPECT_EQ(load_permille(plan, {1000000, 2000000}), 665 + 5);
  EXPECT_LT(load_permille(plan, {1000000, 2000000}), kHighestLoad_permille);
}

// Three DOFs with displacement, velocity and acceleration of 24 bits at 1 kHz. A frame of 8 bytes takes at most 135 bits
// and carries 48 bits of codes beside its number: six frames of k24 are 810 bits each millisecond, five pairs 675. So at
// 1 Mbit/s pairs fit and k24 does not; 500 kbit/s is too little even for the bare 216 bits of codes in 8-byte frames
// without a number (4 of them, 540 bits). With CAN FD three frames of 16 bytes do.
TEST(BusPlan, NineChannelsOf24BitsFitAMegabitAsPairs) {
  CoreConfiguration configuration;
  configuration.dof_count = 3;
  for (int node = 0; node < 3; ++node)
    for (int quantity = 1; quantity < kQuantities; ++quantity) configuration.channels[node][quantity].present = true;
  const auto load = [&](SensorWiring wiring, const BitRates& rates) {
    const SensorPlan sensors = sensor_plan(configuration, wiring);
    BusTraffic traffic;
    traffic.sensors = &sensors;
    traffic.unknowns = 5;
    traffic.channels = 9;
    return load_permille(bus_plan(traffic), rates);
  };
  EXPECT_GT(load(SensorWiring::k24, {1000000, 1000000}), 810);
  EXPECT_GE(load(SensorWiring::kPairs, {1000000, 1000000}), 675);
  EXPECT_LT(load(SensorWiring::kPairs, {1000000, 1000000}), 700);
  EXPECT_GT(load(SensorWiring::kPairs, {500000, 500000}), 1350);
  EXPECT_LT(load(SensorWiring::kFd, {500000, 2000000}), kHighestLoad_permille);
}

TEST(BusPlan, OtherWiringsSendOtherFrames) {
  const auto frames = [](const BusPlan& plan, const can::FrameDescription& frame) {
    for (int i = 0; i < plan.count; ++i)
      if (plan.streams[i].frame == &frame) return plan.streams[i].frames;
    return 0;
  };
  const SensorPlan narrow = three_dofs(SensorWiring::k16), fd = three_dofs(SensorWiring::kFd);
  const BusPlan classic = bus_plan(traffic(narrow));
  EXPECT_EQ(frames(classic, can::kSensorMotion16), 3);
  EXPECT_EQ(frames(classic, can::kSensorForce), 1);
  EXPECT_EQ(frames(classic, can::kEstimate), 5);
  BusTraffic fast = traffic(fd);
  fast.can_fd = true;
  fast.drive_on_can = false;
  fast.heartbeat_ms = 0;
  const BusPlan flexible = bus_plan(fast);
  EXPECT_EQ(frames(flexible, can::kSensorFd), 3);
  EXPECT_EQ(frames(flexible, can::kEstimate), 0);
  EXPECT_EQ(frames(flexible, can::kEstimateFd), 1);
  EXPECT_EQ(frames(flexible, can::kDrive), 0);
  EXPECT_EQ(frames(flexible, can::kHeartbeat), 0);
  // The estimates once more as floats: as many frames again.
  fast.float_estimates = true;
  EXPECT_EQ(frames(bus_plan(fast), can::kEstimateFloatFd), 1);
  fast.can_fd = false;
  EXPECT_EQ(frames(bus_plan(fast), can::kEstimateFloat), 5);
  // A bus without sensor frames: reports alone, under a per cent and a half.
  BusTraffic reports = traffic(fd);
  reports.sensors = nullptr;
  reports.drive_on_can = false;
  EXPECT_LT(load_permille(bus_plan(reports), {500000, 2000000}), 25);
}

TEST(BusPlan, FasterSamplingIsMoreLoad) {
  const SensorPlan sensors = three_dofs(SensorWiring::k24);
  BusTraffic fast = traffic(sensors);
  fast.sample_period_ns = 200000;  // 5 kHz: five times 665 bits each ms, 333 % of 1 Mbit/s
  EXPECT_GE(load_permille(bus_plan(fast), {1000000, 2000000}), 3325);
}

// A frame that the table says is sent again and again is in the plan of some rig: a new one is not forgotten.
TEST(BusPlan, EveryFrameThatRepeatsIsCounted) {
  for (const can::FrameDescription* frame : can::kFrames) {
    if (frame->cycle_ms == 0) continue;
    bool counted = false;
    for (const SensorWiring wiring : {SensorWiring::k16, SensorWiring::k24, SensorWiring::kFd, SensorWiring::kPairs})
      for (const bool can_fd : {false, true}) {
        const SensorPlan sensors = three_dofs(wiring);
        BusTraffic all = traffic(sensors);
        all.can_fd = can_fd;
        all.float_estimates = true;
        const BusPlan plan = bus_plan(all);
        for (int i = 0; i < plan.count; ++i) counted = counted || plan.streams[i].frame == frame;
      }
    EXPECT_TRUE(counted) << frame->name;
  }
}

// The largest rig: every stream has its place.
TEST(BusPlan, NothingIsLeftOutOfTheLargest) {
  SensorPlan sensors;
  const SensorWiring wirings[] = {SensorWiring::k16, SensorWiring::k24, SensorWiring::kFd};
  for (int node = 0; node < kMaxNodes; ++node) {
    sensors.wiring[node] = wirings[node % 3];
    sensors.expected[node] = node % 3 == 2 ? 1 : 3;
  }
  const BusPlan plan = bus_plan(traffic(sensors));
  // Sensors 5, drive, window, estimate, heartbeat, status, 6 each second, parameter, scaling, range.
  EXPECT_EQ(plan.count, 19);
}

}  // namespace
