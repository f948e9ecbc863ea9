// The drive over CAN while the samples come from elsewhere: what a dead bus does to the rig, and what comes back after it.
#include <gtest/gtest.h>

#include <cstring>

#include "tests/rig_controller/bench.hpp"

namespace {

using bench::Bench;
using firmware::AlarmCause;
using firmware::ControllerMode;

constexpr uint32_t kDriveId = 0x201;

firmware::ControllerConfiguration over_can() {
  auto configuration = bench::driving();
  configuration.node.drive_on_can = true;
  configuration.programme.limits.step_per_sample = firmware::Drive::from_raw(1 << 26);
  // 2^28 * 2 pi / 50 from sample to sample at the most: half of what is allowed.
  for (auto& level : configuration.programme.levels) level.amplitude = firmware::Drive::from_raw(1 << 28);
  return configuration;
}

int32_t drive_of(const hal::CanFrame& frame) {
  int32_t drive = 0;
  std::memcpy(&drive, frame.data, 4);
  return drive;
}

void drive_into_settling(Bench& bench) {
  bench.run_samples(2);
  ASSERT_TRUE(bench.controller->start());
  ASSERT_TRUE(bench.run_until(ControllerMode::kSettle));
  bench.run_samples(30);
}

// The largest change from one drive frame that the bus took to the next, beginning with frame number `from`; zero apart.
int64_t steepest(const Bench& bench, size_t from) {
  int64_t largest = 0, before = 0;
  size_t number = 0;
  for (const hal::CanFrame& frame : bench.can.sent()) {
    if (frame.id != kDriveId) continue;
    const int64_t drive = drive_of(frame);
    if (number++ >= from && drive != 0) largest = std::max(largest, std::abs(drive - before));
    before = drive;
  }
  return largest;
}

TEST(DriveLink, ADeadBusStopsTheProgrammeWithinTenMilliseconds) {
  const std::pair<hal::BusFailure, bool> failures[] = {
      {hal::BusFailure::kQueueFull, false},
      {hal::BusFailure::kDown, false},
      {hal::BusFailure::kDriverFault, false},
      {hal::BusFailure::kNone, true}};  // bus-off, told by an error frame
  for (const auto& [failure, bus_off] : failures) {
    SCOPED_TRACE(static_cast<int>(failure));
    Bench bench(over_can());
    drive_into_settling(bench);
    bench.can.fail(failure);
    if (bus_off) bench.can.inject(hal::ErrorFrame::kBusOff);
    bench.run_samples(10);
    EXPECT_TRUE(bench.relay.active());
    bench.run_samples(1);
    EXPECT_FALSE(bench.relay.active());
    EXPECT_EQ(bench.controller->latched_alarm().cause, AlarmCause::kDriveNotTaken);
    EXPECT_EQ(bench.controller->latched_alarm().detail, 10u);
    EXPECT_FALSE(bench.controller->reset());  // the amplifier has not been told to stand still
    bench.run_samples(100);
    EXPECT_EQ(bench.controller->safe_state().state(), firmware::SafeState::State::kStopping);
    // The bus comes back: the first drive frame says zero and STOPPED, and nothing moves before RESET and START.
    const size_t before = bench.can.count(kDriveId);
    bench.can.fail(hal::BusFailure::kNone);
    if (bus_off) bench.can.inject(hal::ErrorFrame::kRestarted);
    bench.run_samples(20);
    ASSERT_GT(bench.can.count(kDriveId), before);
    size_t number = 0;
    for (const hal::CanFrame& frame : bench.can.sent()) {
      if (frame.id != kDriveId || number++ < before) continue;
      EXPECT_EQ(drive_of(frame), 0);
      EXPECT_EQ(frame.data[6], 2);
    }
    EXPECT_TRUE(bench.controller->reset());
    EXPECT_TRUE(bench.controller->start());
    bench.run_samples(200);
    EXPECT_TRUE(bench.relay.active());
    EXPECT_LE(steepest(bench, before), 1 << 26);
  }
}

// An outage too short to stop for: the command goes on from what the amplifier has, at the slew limit.
TEST(DriveLink, AShortOutageKeepsTheSlewLimit) {
  for (int outage = 1; outage < 10; ++outage) {
    Bench bench(over_can());
    drive_into_settling(bench);
    bench.can.fail(hal::BusFailure::kQueueFull);
    bench.run_samples(outage);
    bench.can.fail(hal::BusFailure::kNone);
    bench.run_samples(100);
    EXPECT_FALSE(bench.controller->latched_alarm()) << outage;
    EXPECT_TRUE(bench.relay.active()) << outage;
    EXPECT_LE(steepest(bench, 0), 1 << 26) << outage;
    EXPECT_GT(steepest(bench, 0), 1 << 24) << outage;
  }
}

TEST(DriveLink, AStartByItselfWaitsForTheBusToComeUp) {
  auto configuration = over_can();
  configuration.programme.start_at_boot = true;
  Bench bench(configuration);
  bench.can.fail(hal::BusFailure::kDown);
  bench.run_samples(500);
  EXPECT_FALSE(bench.relay.active());
  bench.can.fail(hal::BusFailure::kNone);
  bench.run_samples(30);
  EXPECT_TRUE(bench.relay.active());
  EXPECT_EQ(bench.controller->mode(), ControllerMode::kRamp);
}

// Samples that have waited in the driver since before the program's first step do not stop the programme that it starts.
TEST(DriveLink, AStartByItselfWaitsForFreshSamples) {
  Bench bench(bench::driving_at_boot());
  std::vector<firmware::RawSample> waiting(200);
  for (size_t i = 0; i < waiting.size(); ++i) {
    waiting[i].sequence = bench.sequence++;
    waiting[i].time_ns = (i + 1) * bench::kMillisecond_ns;
  }
  bench.clock.set_ns(200 * bench::kMillisecond_ns);
  bench.source = hal::FakeSampleSource(waiting);
  bench.source.release(waiting.size() - 1);  // the last one is kept back: after it the source would end
  bench.step();
  EXPECT_FALSE(bench.relay.active());
  bench.step();
  bench.step();
  bench.step();
  EXPECT_FALSE(bench.controller->latched_alarm());
  EXPECT_TRUE(bench.relay.active());
}

}  // namespace
