// Estimates that take longer than a sample period: worked out beside the controller, they are the same, and nothing
// waits for them. The fake worker takes as many steps as it is told.
#include <gtest/gtest.h>

#include <vector>

#include "hal/fake/fake_worker.hpp"
#include "tests/rig_controller/bench.hpp"

namespace {

using bench::Bench;
using firmware::ControllerMode;

constexpr uint32_t kWindowId = 0x391;

struct SlowBench : Bench {
  SlowBench(const firmware::ControllerConfiguration& asked, int steps) : Bench(asked) {
    slow.takes(steps);
    worker = &slow;
    restart();
    step();
  }
  hal::FakeWorker slow;
};

// Window and estimate frames in the order of their sending, as identifier and bytes.
std::vector<std::vector<uint32_t>> estimate_frames(const Bench& bench) {
  std::vector<std::vector<uint32_t>> frames;
  for (const hal::CanFrame& frame : bench.can.sent()) {
    if (frame.id != kWindowId && (frame.id < 0x400 || frame.id >= 0x480)) continue;
    frames.push_back({frame.id});
    for (int i = 0; i < frame.length; ++i) frames.back().push_back(frame.data[i]);
  }
  return frames;
}

firmware::ControllerConfiguration short_windows() {
  auto configuration = bench::driving();
  configuration.node.window_samples = 200;
  return configuration;
}

TEST(Estimation, SameFramesHoweverLongItTakes) {
  std::vector<std::vector<uint32_t>> expected;
  for (int steps : {-2, 0, 1, 37, 150}) {
    SlowBench bench(short_windows(), steps < 0 ? 0 : steps);
    if (steps < 0) {
      bench.worker = nullptr;
      bench.restart();
      bench.step();
    }
    ASSERT_TRUE(bench.controller->start());
    for (int i = 0; i < 20000 && !bench.controller->finished(); ++i) bench.run_sample();
    EXPECT_TRUE(bench.controller->finished());
    const auto frames = estimate_frames(bench);
    if (steps < 0) expected = frames;
    // 1000 samples a level and the core's margin: five windows of 200, one at the end; an estimate and a window frame
    // each.
    EXPECT_EQ(frames.size(), 24u) << steps;
    EXPECT_EQ(frames, expected) << steps;
  }
}

TEST(Estimation, DriveAndStopLineDoNotWait) {
  SlowBench bench(short_windows(), hal::FakeWorker::kUntilTold);
  ASSERT_TRUE(bench.controller->start());
  ASSERT_TRUE(bench.run_until(ControllerMode::kIntegrate));
  bench.run_samples(250);
  ASSERT_EQ(bench.slow.starts(), 1);
  ASSERT_FALSE(bench.slow.done());
  const uint64_t writes = bench.drive.writes();
  bench.run_samples(100);
  EXPECT_EQ(bench.drive.writes(), writes + 100);
  EXPECT_FALSE(bench.controller->latched_alarm());
  bench.stop_line.set(true, 0);
  bench.step();
  EXPECT_TRUE(bench.dead());
  EXPECT_EQ(bench.slow.waits(), 0);
  EXPECT_EQ(bench.can.count(kWindowId), 0u);
}

TEST(Estimation, WhatWasForgottenIsNotShown) {
  SlowBench slow(short_windows(), hal::FakeWorker::kUntilTold), quick(short_windows(), 0);
  for (Bench* bench : {static_cast<Bench*>(&slow), static_cast<Bench*>(&quick)}) {
    EXPECT_TRUE(bench->controller->start());
    EXPECT_TRUE(bench->run_until(ControllerMode::kIntegrate));
    bench->run_samples(250);
    bench->stop_line.pulse(0);
    bench->run_samples(2);
    bench->network_command(129, 0);
    bench->run_samples(500);  // the rig comes to rest
    EXPECT_TRUE(bench->controller->start());
    EXPECT_TRUE(bench->run_until(ControllerMode::kIntegrate));
  }
  EXPECT_EQ(quick.can.count(kWindowId), 1u);
  EXPECT_EQ(slow.can.count(kWindowId), 0u);
  slow.slow.finish();  // the solve of the first run, forgotten by now
  slow.slow.takes(0);
  slow.run_samples(100);
  EXPECT_EQ(slow.can.count(kWindowId), 0u);
  EXPECT_EQ(slow.controller->estimates(), nullptr);
  quick.run_samples(100);
  for (Bench* bench : {static_cast<Bench*>(&slow), static_cast<Bench*>(&quick)}) bench->run_samples(150);
  ASSERT_EQ(slow.can.count(kWindowId), 1u);
  EXPECT_EQ(slow.controller->estimates()->window_counter, 1u);
  const auto late = estimate_frames(slow), direct = estimate_frames(quick);
  ASSERT_EQ(late.size(), 2u);
  ASSERT_EQ(direct.size(), 4u);
  EXPECT_EQ(late[1], direct[3]);
}

// 1024 places, 32 of them not for samples: 992 samples wait, the other 108 of 1100 are dropped and counted.
TEST(Estimation, SamplesThatFindNoRoomAreCountedAsMissed) {
  SlowBench bench(bench::listening(), hal::FakeWorker::kUntilTold);
  bench.run_samples(1000);
  ASSERT_EQ(bench.slow.starts(), 1);
  bench.run_samples(1100);
  bench.slow.takes(0);
  bench.slow.finish();
  bench.run_samples(400);  // three more than come are taken with each: 992 / 3 = 331 steps
  EXPECT_EQ(bench.controller->core().health().missed_samples, 108u);
  EXPECT_EQ(bench.controller->core().health().samples, 1000u + 992u + 400u);
  EXPECT_EQ(bench.slow.starts(), 2);  // the window at sample 2000 was asked for meanwhile
  bench.run_samples(1000);
  const hal::CanFrame* health = bench.can.last(0x281);
  ASSERT_NE(health, nullptr);
  EXPECT_EQ(health->data[3] | health->data[4] << 8, 108);  // missed_samples
  EXPECT_EQ(bench.slow.waits(), 0);
}

TEST(Estimation, OneSolveWaitsAtMost) {
  SlowBench bench(bench::listening(), hal::FakeWorker::kUntilTold);
  for (int i = 0; i < 5; ++i) {
    bench.run_samples(100);
    bench.sync();
    bench.run_samples(1);
  }
  EXPECT_EQ(bench.slow.starts(), 1);
  bench.slow.takes(0);
  bench.slow.finish();
  bench.run_samples(200);
  EXPECT_EQ(bench.slow.starts(), 2);
  EXPECT_EQ(bench.can.count(kWindowId), 2u);
  ASSERT_NE(bench.controller->estimates(), nullptr);
  EXPECT_EQ(bench.controller->estimates()->window_counter, 2u);
  EXPECT_EQ(bench.controller->core().health().samples, 705u);
}

// A high-pass that settles for 1024 samples (16 << 6 for three sections; 2^-6 a sample), and solves that take 1100: each costs a
// gap of some 100 samples behind 992 that waited. One after the other no stretch between two gaps outlasts the settling, and the
// estimates stand still. Put off for twice the margin, a stretch is 2 * 1028 and the 992 that wait during the next solve: of
// 3050 samples some 2000 are measured, and with the gap and what is at hand at the end well over half of all.
TEST(Estimation, SolvesThatOutlastTheRingLeaveSamplesToMeasure) {
  auto configuration = bench::listening();
  configuration.core.high_pass_order = 3;
  configuration.core.high_pass_shift = 6;
  SlowBench bench(configuration, 1100);
  constexpr int kSamples = 60000;
  bench.run_samples(kSamples);
  const firmware::BatchTable& table = bench.controller->core().table();
  uint32_t measured = 0;
  for (int b = 0; b < table.level[0].batch_count; ++b) measured += table.level[0].batch[b].samples;
  EXPECT_GT(measured, kSamples / 2u);
  ASSERT_NE(bench.controller->estimates(), nullptr);
  EXPECT_GT(bench.controller->estimates()->window_counter, 10u);
  EXPECT_EQ(bench.slow.waits(), 0);
}

// Far more starts, stops and windows than the ring has places, all during one solve.
TEST(Estimation, NoStepWaitsForTheWorkerWhateverIsAskedFor) {
  auto configuration = bench::listening();
  configuration.node.listen_on_command = true;
  SlowBench bench(configuration, hal::FakeWorker::kUntilTold);
  bench.network_command(1, 0);
  bench.run_samples(300);
  bench.sync();
  bench.run_samples(1);
  ASSERT_EQ(bench.slow.starts(), 1);
  bench.run_samples(1000);
  EXPECT_EQ(bench.slow.waits(), 0);
  for (int i = 0; i < 2000; ++i) {
    bench.network_command(2, 0);
    bench.run_samples(1);
    bench.network_command(1, 0);
    bench.run_samples(1);
  }
  EXPECT_EQ(bench.slow.waits(), 0);
  EXPECT_EQ(bench.slow.starts(), 1);
  EXPECT_FALSE(bench.controller->latched_alarm());
  bench.slow.takes(0);
  bench.slow.finish();
  bench.run_samples(500);
  EXPECT_EQ(bench.slow.waits(), 0);
  EXPECT_EQ(bench.controller->mode(), ControllerMode::kIdle);  // the eighth level was the last that was begun
  EXPECT_EQ(bench.controller->core().table().level_count, firmware::kMaxLevels);
  // What found no room was told: samples missed, FF04.
  ASSERT_NE(bench.can.last(0x081), nullptr);
  EXPECT_EQ(bench.can.last(0x081)->data[0] | bench.can.last(0x081)->data[1] << 8, 0xFF04);
}

// SYNC with every sample during one solve: each asks for a solve, one is owed in the end, and no sample is lost.
TEST(Estimation, SupersededSolvesTakeNoRoom) {
  SlowBench bench(bench::listening(), hal::FakeWorker::kUntilTold);
  bench.run_samples(100);
  for (int i = 0; i < 900; ++i) {
    bench.sync();
    bench.run_samples(1);
  }
  EXPECT_EQ(bench.slow.starts(), 1);
  bench.slow.takes(0);
  bench.slow.finish();
  bench.run_samples(400);
  EXPECT_EQ(bench.slow.starts(), 2);
  EXPECT_EQ(bench.controller->core().health().missed_samples, 0u);
  EXPECT_EQ(bench.controller->core().health().samples, 1400u);
}

TEST(Estimation, AWorkerThatDoesNotComeBackStopsTheDriveAndTheWatchdogsFeed) {
  auto configuration = short_windows();
  configuration.programme.levels[0].measure_samples = 1000000;
  SlowBench bench(configuration, hal::FakeWorker::kUntilTold);
  ASSERT_TRUE(bench.controller->start());
  ASSERT_TRUE(bench.run_until(ControllerMode::kIntegrate));
  bench.run_samples(300);
  ASSERT_EQ(bench.slow.starts(), 1);
  uint64_t feeds = bench.watchdog.feeds();
  bench.run_samples(1000);
  EXPECT_EQ(bench.watchdog.feeds(), feeds + 1000);  // a long solve is no fault
  bench.run_samples(20000);
  EXPECT_EQ(bench.controller->latched_alarm().cause, firmware::AlarmCause::kWorkerLate);
  EXPECT_TRUE(bench.dead());
  feeds = bench.watchdog.feeds();
  bench.run_samples(1000);
  EXPECT_EQ(bench.watchdog.feeds(), feeds);
  int told = 0;
  for (const hal::CanFrame& frame : bench.can.sent())
    told += frame.id == 0x081 && (frame.data[0] | frame.data[1] << 8) == 0x6000 ? 1 : 0;
  EXPECT_EQ(told, 1);
  bench.slow.takes(0);
  bench.slow.finish();
  bench.run_samples(10);
  EXPECT_GT(bench.watchdog.feeds(), feeds);
  EXPECT_TRUE(bench.controller->reset());
}

}  // namespace
