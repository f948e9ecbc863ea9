// One simulated hour at 1 kHz: the controller never asks for memory, misses nothing, and keeps its schedule to the end.
#include <gtest/gtest.h>
#include <malloc.h>

#include <memory>

#include "tests/footprint/allocation_counter.hpp"
#include "tests/rig_controller/bench.hpp"

namespace {

constexpr int kHour_samples = 3600 * 1000;

TEST(AllocationCounter, Counts) {
  const auto before = footprint::allocation_count();
  auto made = std::make_unique<int>(1);
  EXPECT_GT(footprint::allocation_count(), before);
  EXPECT_EQ(*made, 1);
}

// Faults and bus troubles are part of the hour: nothing of them may allocate either.
void disturb(bench::Bench& bench, int sample) {
  if (sample % 10000 == 5000) bench.can.fail(hal::BusFailure::kQueueFull);
  if (sample % 10000 == 5200) bench.can.fail(hal::BusFailure::kDown);
  if (sample % 10000 == 5400) bench.can.fail(hal::BusFailure::kNone);
  if (sample % 7000 == 0) ++bench.sequence;
}

TEST(Endurance, OneHourOfListeningWithoutAnAllocation) {
  bench::Bench bench(bench::listening());
  bench.can.keep_frames(false);
  bench.run_samples(2000);
  const auto allocations = footprint::allocation_count();
  const auto in_use = mallinfo2().uordblks;
  for (int sample = 0; sample < kHour_samples; ++sample) {
    disturb(bench, sample);
    bench.run_sample();
  }
  EXPECT_EQ(footprint::allocation_count(), allocations);
  EXPECT_EQ(mallinfo2().uordblks, in_use);
  EXPECT_EQ(bench.controller->core().health().samples, static_cast<uint32_t>(kHour_samples) + 2000);
  EXPECT_EQ(bench.controller->counters().missed_samples, 515u);  // 3,600,000 / 7000 = 514.3, and the one at 0
  EXPECT_EQ(bench.controller->bus().health().interface_down, 360u);
  EXPECT_EQ(bench.watchdog.feeds(), static_cast<uint64_t>(kHour_samples) + 2000);
  // 30,000 heartbeats, status and so on would be 36,000 each without the 200 + 200 ms of every 10 s in which nothing
  // goes out.
  EXPECT_GT(bench.can.sent_count(), 2u * 34000 + 7u * 3600);
}

TEST(Endurance, ManyProgrammesWithoutAnAllocation) {
  auto configuration = bench::driving();
  configuration.node.drive_on_can = true;
  bench::Bench bench(configuration);
  bench.can.keep_frames(false);
  bench.step();
  ASSERT_TRUE(bench.controller->start());
  bench.run_samples(5000);
  const auto allocations = footprint::allocation_count();
  int finished = 0, stopped = 0;
  for (int programme = 0; programme < 60; ++programme) {
    bench.controller->start();
    const bool interrupted = programme % 3 == 2;
    for (int sample = 0; sample < 4000 && !bench.controller->finished(); ++sample) {
      if (interrupted && sample == 1500) ++bench.sequence, bench.sequence += 5;  // lost frames stop it
      bench.run_sample();
    }
    finished += bench.controller->finished() ? 1 : 0;
    stopped += bench.controller->latched_alarm() ? 1 : 0;
    bench.controller->reset();
  }
  EXPECT_EQ(footprint::allocation_count(), allocations);
  EXPECT_EQ(finished, 40);
  EXPECT_EQ(stopped, 20);
}

}  // namespace
