// Which frame goes out how often, counted over simulated time; and what closes a window.
#include <gtest/gtest.h>

#include "tests/rig_controller/bench.hpp"

namespace {

using bench::Bench;
using firmware::ControllerMode;

constexpr uint32_t kHeartbeat = 0x701, kEmergency = 0x081, kStatus = 0x181, kHealth = 0x281, kBusHealth = 0x291,
                   kIdentity = 0x381, kWindow = 0x391, kEstimate0 = 0x410, kDiagnosis = 0x481, kParameter = 0x681,
                   kScaling = 0x691, kRange = 0x6A1, kDrive = 0x201;

uint32_t word(const hal::CanFrame& frame, int place) {
  uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | frame.data[place + i];
  return value;
}

TEST(Schedule, TenSecondsOfListening) {
  Bench bench(bench::listening());
  bench.step();
  ASSERT_FALSE(bench.can.sent().empty());
  EXPECT_EQ(bench.can.sent().front().id, kHeartbeat);  // the boot-up message comes first, once
  EXPECT_EQ(bench.can.sent().front().data[0], 0);
  bench.run_samples(9999);  // 1 kHz: 9.999 s after the first step
  // At the times 0, 100, ... 9900 ms: 100 of each; heartbeats begin with the boot-up message at 0.
  EXPECT_EQ(bench.can.count(kHeartbeat), 100u);
  EXPECT_EQ(bench.can.count(kStatus), 100u);
  EXPECT_EQ(bench.can.count(kHealth), 10u);
  EXPECT_EQ(bench.can.count(kBusHealth), 10u);
  EXPECT_EQ(bench.can.count(kIdentity), 10u);
  EXPECT_EQ(bench.can.count(kDiagnosis), 0u);   // nothing has moved: nothing can be judged
  EXPECT_EQ(bench.can.count(kParameter), 10u);  // one unknown
  EXPECT_EQ(bench.can.count(kScaling), 8u);     // four channels at 0 and 5 s
  EXPECT_EQ(bench.can.count(kRange), 8u);
  EXPECT_EQ(bench.can.count(kWindow), 9u);  // every 1000 samples of 9999
  EXPECT_EQ(bench.can.count(kEstimate0), 9u);
  EXPECT_EQ(bench.can.count(kEmergency), 0u);
  EXPECT_EQ(bench.can.count(kDrive), 0u);
  int boot_ups = 0;
  for (const hal::CanFrame& frame : bench.can.sent()) boot_ups += frame.id == kHeartbeat && frame.data[0] == 0 ? 1 : 0;
  EXPECT_EQ(boot_ups, 1);
}

TEST(Schedule, LostSensorFramesAreToldWithTheBusHealth) {
  Bench bench(bench::listening());
  bench.run_samples(1500);
  EXPECT_EQ(bench.can.last(kBusHealth)->data[6], 0);
  bench.source.lose_frames(258);
  bench.run_samples(1000);
  EXPECT_EQ(bench.can.last(kBusHealth)->data[6], 2);  // 258 = 0x0102, low byte first
  EXPECT_EQ(bench.can.last(kBusHealth)->data[7], 1);
}

TEST(Schedule, WindowLengthAndOtherNodes) {
  auto configuration = bench::listening();
  configuration.node.node = 7;
  configuration.node.window_samples = 50;
  Bench bench(configuration);
  bench.run_samples(1000);
  EXPECT_EQ(bench.can.count(0x400 + 16 * 7), 20u);
  EXPECT_EQ(bench.can.count(0x397), 20u);
  EXPECT_EQ(bench.can.count(kEstimate0), 0u);
}

TEST(Schedule, FdBusSendsTheEstimatesInOneFrame) {
  auto configuration = bench::listening();
  configuration.node.can_fd = true;
  Bench bench(configuration);
  bench.run_samples(1001);
  EXPECT_EQ(bench.can.count(kEstimate0), 0u);
  ASSERT_NE(bench.can.last(0x2C8), nullptr);
  EXPECT_TRUE(bench.can.last(0x2C8)->fd);
  EXPECT_EQ(bench.can.last(0x2C8)->length, 64);
}

TEST(Schedule, TheEstimatesGoOutAsFloatsTooWhereTheLoadAllows) {
  Bench bench(bench::listening());  // few estimates, each second
  bench.run_samples(1001);
  EXPECT_EQ(bench.can.count(0x590), bench.can.count(kEstimate0));
  EXPECT_GT(bench.can.count(0x590), 0u);

  auto configuration = bench::listening();
  configuration.node.float_estimates = firmware::FloatEstimates::kNever;
  Bench silent(configuration);
  silent.run_samples(1001);
  EXPECT_EQ(silent.can.count(0x590), 0u);
  EXPECT_GT(silent.can.count(kEstimate0), 0u);

  configuration.node.float_estimates = firmware::FloatEstimates::kAlways;
  configuration.node.can_fd = true;
  Bench fd(configuration);
  fd.run_samples(1001);
  EXPECT_EQ(fd.can.count(0x590), 0u);
  ASSERT_NE(fd.can.last(0x338), nullptr);
  EXPECT_EQ(fd.can.last(0x338)->length, 64);
}

TEST(Schedule, SyncFrameAndSyncEdgeCloseTheWindow) {
  Bench bench(bench::listening());
  bench.run_samples(100);
  bench.sync();
  bench.run_sample();
  EXPECT_EQ(bench.can.count(kWindow), 1u);
  bench.run_samples(100);
  bench.sync_line.pulse(bench.clock.now_ns());
  bench.run_sample();
  EXPECT_EQ(bench.can.count(kWindow), 2u);  // one rising edge, one window
  // The next regular window counts from there: 1000 samples later.
  bench.run_samples(999);
  EXPECT_EQ(bench.can.count(kWindow), 2u);
  bench.run_samples(2);
  EXPECT_EQ(bench.can.count(kWindow), 3u);
}

TEST(Schedule, SyncDoesNothingWhereItIsSwitchedOffOrNothingIsMeasured) {
  auto configuration = bench::listening();
  configuration.node.sync_closes_window = false;
  Bench deaf(configuration);
  deaf.run_samples(100);
  deaf.sync();
  deaf.run_sample();
  EXPECT_EQ(deaf.can.count(kWindow), 0u);
  Bench idle(bench::driving());
  idle.run_samples(100);
  idle.sync();
  idle.run_sample();
  EXPECT_EQ(idle.can.count(kWindow), 0u);
}

TEST(Schedule, EndOfTheSourceClosesTheLevel) {
  Bench bench(bench::listening());
  bench.run_samples(1500);
  bench.source.fail(hal::SampleFailure::kEnded);
  bench.run_idle(10);
  EXPECT_TRUE(bench.controller->finished());
  EXPECT_EQ(bench.controller->mode(), ControllerMode::kDone);
  EXPECT_EQ(bench.can.count(kWindow), 2u);
  EXPECT_EQ(bench.can.count(kEmergency), 0u);
}

TEST(Schedule, ProgrammeRunsThroughItsModesAndSendsItsDrive) {
  auto configuration = bench::driving();
  configuration.node.drive_on_can = true;
  configuration.programme.start_at_boot = true;
  Bench bench(configuration);
  bench.run_sample();
  EXPECT_EQ(bench.controller->mode(), ControllerMode::kRamp);
  EXPECT_TRUE(bench.relay.active());
  for (ControllerMode mode : {ControllerMode::kSettle, ControllerMode::kIntegrate, ControllerMode::kRamp,
                              ControllerMode::kSettle, ControllerMode::kIntegrate, ControllerMode::kRamp}) {
    EXPECT_TRUE(bench.run_until(mode)) << static_cast<int>(mode);
    EXPECT_TRUE(bench.relay.active());
  }
  EXPECT_TRUE(bench.run_until(ControllerMode::kDone));
  EXPECT_TRUE(bench.dead());
  EXPECT_TRUE(bench.controller->finished());
  EXPECT_EQ(bench.can.count(kWindow),
            4u);  // each level: after 1000 samples, and when its margin is in and it is closed
  EXPECT_EQ(bench.can.count(kEmergency), 0u);
  ASSERT_NE(bench.can.last(kDrive), nullptr);
  EXPECT_EQ(word(*bench.can.last(kDrive), 0), 0u);
  EXPECT_GT(bench.can.count(kDrive), 2000u);
}

TEST(Schedule, StatusTellsTheMode) {
  Bench bench(bench::driving());
  bench.step();
  EXPECT_EQ(bench.can.last(kStatus)->data[2] & 0x0F, 1);  // IDLE
  bench.network_command(1, 0);
  bench.run_samples(101);
  EXPECT_EQ(bench.can.last(kStatus)->data[2] & 0x0F, 2);  // RAMP
  EXPECT_EQ(bench.can.last(kHeartbeat)->data[0], 5);      // OPERATIONAL
}

TEST(Schedule, NetworkCommandsReachTheirNodeOnly) {
  Bench bench(bench::driving());
  bench.network_command(1, 2);
  bench.run_samples(5);
  EXPECT_EQ(bench.controller->mode(), ControllerMode::kIdle);
  bench.network_command(1, 1);
  bench.run_samples(5);
  EXPECT_EQ(bench.controller->mode(), ControllerMode::kRamp);
  bench.network_command(2, 0);
  EXPECT_TRUE(bench.run_until(ControllerMode::kDone, 200));
  EXPECT_TRUE(bench.dead());
  bench.network_command(1, 1);  // and again from the start
  bench.run_samples(5);
  EXPECT_EQ(bench.controller->mode(), ControllerMode::kRamp);
}

}  // namespace
