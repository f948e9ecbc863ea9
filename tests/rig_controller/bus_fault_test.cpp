// What goes wrong on the bus: each ten times in a row, the node back with a heartbeat, the counters right, nothing
// blocked.
#include <gtest/gtest.h>

#include "tests/rig_controller/bench.hpp"

namespace {

using bench::Bench;

constexpr uint32_t kEmergencyId = 0x081, kStatusId = 0x181, kHealthId = 0x281, kBusHealthId = 0x291, kWindowId = 0x391,
                   kHeartbeatId = 0x701;

uint16_t half_word(const hal::CanFrame& frame, int place) {
  return static_cast<uint16_t>(frame.data[place] | frame.data[place + 1] << 8);
}

int boot_ups(const Bench& bench) {
  int count = 0;
  for (const hal::CanFrame& frame : bench.can.sent()) count += frame.id == kHeartbeatId && frame.data[0] == 0 ? 1 : 0;
  return count;
}

size_t told(const Bench& bench, uint16_t code) {
  size_t count = 0;
  for (const hal::CanFrame& frame : bench.can.sent())
    count += frame.id == kEmergencyId && half_word(frame, 0) == code ? 1 : 0;
  return count;
}

TEST(BusFaults, InterfaceDownTenTimes) {
  Bench bench(bench::listening());
  bench.run_samples(10);
  for (int round = 1; round <= 10; ++round) {
    bench.can.fail(hal::BusFailure::kDown);
    bench.run_samples(2000);
    bench.can.fail(hal::BusFailure::kNone);
    const size_t beats = bench.can.count(kHeartbeatId);
    bench.run_samples(12);  // a trial every 10 ms
    EXPECT_GT(bench.can.count(kHeartbeatId), beats) << round;
    bench.run_samples(300);
    EXPECT_EQ(told(bench, 0x8140), static_cast<size_t>(round));
    EXPECT_EQ(bench.controller->bus().health().interface_down, static_cast<uint32_t>(round));
    EXPECT_EQ(bench.controller->bus().state(), firmware::BusState::kGood);
    EXPECT_EQ(bench.controller->transmit_queue().waiting(), 0);
  }
  EXPECT_EQ(boot_ups(bench), 1);
  bench.run_samples(1000);
  EXPECT_EQ(bench.can.last(kBusHealthId)->data[3], 10);                          // interface_down
  EXPECT_EQ(bench.controller->core().health().samples, 10u + 10 * 2312 + 1000);  // nothing of the measurement is lost
}

TEST(BusFaults, BootUpMessageIsKeptUntilTheBusComesUp) {
  Bench bench(bench::listening());
  bench.can.fail(hal::BusFailure::kDown);
  bench.run_samples(1000);
  bench.can.fail(hal::BusFailure::kNone);
  bench.run_samples(200);
  EXPECT_EQ(boot_ups(bench), 1);
  EXPECT_GT(bench.can.count(kHeartbeatId), 1u);
}

TEST(BusFaults, BusOffAndRestartedTenTimes) {
  Bench bench(bench::listening());
  bench.run_samples(10);
  for (int round = 1; round <= 10; ++round) {
    bench.can.inject(hal::ErrorFrame::kBusOff);
    const size_t sent = bench.can.sent().size();
    bench.run_samples(150);
    EXPECT_EQ(bench.can.sent().size(), sent);  // nothing is sent into a dead bus
    EXPECT_EQ(bench.controller->bus().state(), firmware::BusState::kBusOff);
    bench.can.inject(hal::ErrorFrame::kRestarted);
    const size_t beats = bench.can.count(kHeartbeatId);
    bench.run_samples(2);
    EXPECT_GT(bench.can.count(kHeartbeatId), beats);
    EXPECT_EQ(bench.controller->bus().state(), firmware::BusState::kGood);
    bench.run_samples(300);
  }
  EXPECT_EQ(told(bench, 0x8140), 10u);
  EXPECT_EQ(boot_ups(bench), 1);
  bench.run_samples(1000);
  EXPECT_EQ(bench.can.last(kHealthId)->data[7], 10);     // bus_off
  EXPECT_EQ(bench.can.last(kBusHealthId)->data[0], 10);  // restarts
}

TEST(BusFaults, BusOffWithoutARestartMessageIsLeftOnceSendingWorks) {
  Bench bench(bench::listening());
  bench.run_samples(10);
  for (int round = 1; round <= 10; ++round) {
    bench.can.inject(hal::ErrorFrame::kBusOff);
    bench.run_samples(620);  // half a second of probation, then the next heartbeat
    EXPECT_EQ(bench.controller->bus().state(), firmware::BusState::kGood) << round;
  }
  EXPECT_EQ(bench.controller->bus().bus_off_count(), 10u);
  EXPECT_EQ(bench.controller->bus().health().restarts, 0u);
}

TEST(BusFaults, AReceivedFrameProvesTheBusAlive) {
  Bench bench(bench::listening());
  bench.run_samples(10);
  bench.can.inject(hal::ErrorFrame::kBusOff);
  bench.run_sample();
  bench.sync();
  bench.run_sample();
  EXPECT_EQ(bench.controller->bus().state(), firmware::BusState::kGood);
}

TEST(BusFaults, ErrorPassiveTenTimes) {
  Bench bench(bench::listening());
  bench.run_samples(10);
  for (int round = 1; round <= 10; ++round) {
    bench.can.inject(hal::ErrorFrame::kErrorPassive);
    bench.can.inject(hal::ErrorFrame::kErrorPassive);  // said twice, counted once
    bench.run_samples(150);
    EXPECT_EQ(bench.controller->bus().state(), firmware::BusState::kPassive);
    EXPECT_TRUE(half_word(*bench.can.last(kStatusId), 0) >> 6 & 1);
    const size_t beats = bench.can.count(kHeartbeatId);
    bench.run_samples(100);
    EXPECT_EQ(bench.can.count(kHeartbeatId), beats + 1);  // a passive node still talks
    bench.can.inject(hal::ErrorFrame::kErrorActive);
    bench.run_samples(200);
    EXPECT_EQ(bench.controller->bus().state(), firmware::BusState::kGood);
    EXPECT_FALSE(half_word(*bench.can.last(kStatusId), 0) >> 6 & 1);
  }
  EXPECT_EQ(bench.controller->bus().health().error_passive, 10u);
  EXPECT_EQ(told(bench, 0x8120), 10u);
}

TEST(BusFaults, ControllerOverflowTenTimes) {
  Bench bench(bench::listening());
  bench.run_samples(10);
  for (int round = 1; round <= 10; ++round) {
    bench.can.inject(hal::ErrorFrame::kReceiveOverflow);
    bench.run_samples(150);
  }
  EXPECT_EQ(bench.controller->bus().health().controller_overflow, 10u);
  EXPECT_EQ(told(bench, 0x8110), 10u);
  bench.run_samples(1000);
  EXPECT_EQ(bench.can.last(kBusHealthId)->data[2], 10);
}

TEST(BusFaults, OtherErrorFramesChangeNothing) {
  Bench bench(bench::listening());
  bench.run_samples(10);
  for (int i = 0; i < 1000; ++i) bench.can.inject(hal::ErrorFrame::kNoAcknowledge);
  bench.run_samples(100);
  EXPECT_EQ(bench.controller->bus().state(), firmware::BusState::kGood);
  EXPECT_EQ(bench.can.count(kEmergencyId), 0u);
}

TEST(BusFaults, QueueFullTenTimesKeepsTheUrgentAndCountsTheRest) {
  Bench bench(bench::listening());
  bench.run_samples(10);
  for (int round = 1; round <= 10; ++round) {
    bench.can.fail(hal::BusFailure::kQueueFull);
    const uint32_t given_up = bench.controller->transmit_queue().given_up();
    bench.run_samples(3000);
    EXPECT_GT(bench.controller->transmit_queue().given_up(), given_up);
    bench.can.fail(hal::BusFailure::kNone);
    const size_t beats = bench.can.count(kHeartbeatId);
    const size_t windows = bench.can.count(kWindowId);
    bench.run_sample();
    EXPECT_EQ(bench.can.count(kHeartbeatId), beats + 1);  // the newest of its kind
    EXPECT_GE(bench.can.count(kWindowId), windows + 1);
    EXPECT_EQ(bench.controller->transmit_queue().waiting(), 0);
    bench.run_samples(300);
  }
  EXPECT_EQ(told(bench, 0x8110), 10u);
  bench.run_samples(1000);
  EXPECT_EQ(half_word(*bench.can.last(kBusHealthId), 4), bench.controller->transmit_queue().given_up());
}

// Windows close while the bus is away, and RESET forgets them before it is back: what they said does not come after it. A window
// and an estimate frame wait then, the newest of each.
TEST(BusFaults, WhatWasForgottenDuringAnOutageIsNotSent) {
  auto configuration = bench::listening();
  configuration.node.listen_on_command = true;
  Bench bench(configuration);
  bench.run_samples(10);
  ASSERT_TRUE(bench.controller->start());
  bench.run_samples(500);
  bench.can.fail(hal::BusFailure::kDown);
  bench.run_samples(2000);
  bench.controller->stop();
  bench.run_samples(10);
  EXPECT_EQ(bench.controller->estimates()->window_counter, 3u);
  const uint32_t given_up = bench.controller->transmit_queue().given_up();
  ASSERT_TRUE(bench.controller->reset());
  EXPECT_GE(bench.controller->transmit_queue().given_up(), given_up + 2);
  bench.can.fail(hal::BusFailure::kNone);
  bench.run_samples(300);
  EXPECT_EQ(bench.can.count(kWindowId), 0u);
  EXPECT_EQ(bench.can.count(0x410), 0u);
  EXPECT_GT(bench.can.count(kHeartbeatId), 1u);
}

TEST(BusFaults, EveryFrameIsSentOrCounted) {
  // A queue of three frames, emptied every millisecond: bursts wait, nothing is lost.
  Bench bench(bench::listening());
  bench.can.fail(hal::BusFailure::kShortQueue);
  for (int i = 0; i < 10000; ++i) {
    bench.can.drain();
    bench.run_sample();
  }
  EXPECT_EQ(bench.controller->transmit_queue().given_up(), 0u);
  EXPECT_EQ(bench.can.count(kHeartbeatId), 100u);
  EXPECT_EQ(bench.can.count(kStatusId), 100u);
}

// The queue by itself, worked out by hand.
TEST(TransmitQueue, OnlyFramesThatTheBusRefusedCountAsGivenUp) {
  hal::ManualClock clock;
  hal::FakeCanBus bus(clock);
  firmware::TransmitQueue queue;
  firmware::CanFrame message;
  message.id = 0x181;
  queue.push(message);
  queue.push(message);  // superseded before the bus was asked: no loss
  EXPECT_EQ(queue.given_up(), 0u);
  EXPECT_EQ(queue.waiting(), 1);
  bus.fail(hal::BusFailure::kQueueFull);
  queue.flush(bus);
  queue.push(message);  // the bus has refused the one before
  EXPECT_EQ(queue.given_up(), 1u);
  for (uint32_t i = 0; i < 95; ++i) {
    message.id = 0x200 + i;
    queue.push(message);
  }
  EXPECT_EQ(queue.waiting(), 96);
  EXPECT_EQ(queue.given_up(), 1u);
  message.id = 0x700;  // less urgent than all that wait
  queue.push(message);
  EXPECT_EQ(queue.given_up(), 2u);
  message.id = 0x081;  // the most urgent: 0x200 + 94 goes
  queue.push(message);
  EXPECT_EQ(queue.given_up(), 3u);
  EXPECT_FALSE(queue.has(0x200 + 94));
  bus.fail(hal::BusFailure::kNone);
  EXPECT_EQ(queue.flush(bus), hal::CanResult::kDone);
  ASSERT_EQ(bus.sent().size(), 96u);
  EXPECT_EQ(bus.sent()[0].id, 0x081u);
  EXPECT_EQ(bus.sent()[1].id, 0x181u);
  EXPECT_EQ(bus.sent()[95].id, 0x200u + 93);
  EXPECT_EQ(queue.sent(), 96u);
}

TEST(BusFaults, UrgentFramesGoFirst) {
  Bench bench(bench::listening());
  bench.run_samples(10);
  bench.can.fail(hal::BusFailure::kQueueFull);
  bench.run_samples(1100);
  bench.stop_line.set(true, 0);
  bench.run_samples(10);
  bench.can.fail(hal::BusFailure::kNone);
  const size_t before = bench.can.sent().size();
  bench.run_sample();
  ASSERT_GT(bench.can.sent().size(), before + 3);
  EXPECT_EQ(bench.can.sent()[before].id, kEmergencyId);
  for (size_t i = before + 1; i < bench.can.sent().size(); ++i)
    EXPECT_LE(bench.can.sent()[i - 1].id, bench.can.sent()[i].id);
}

TEST(BusFaults, AFrameThatTheDriverCannotSendDoesNotBlockTheOthers) {
  Bench bench(bench::listening());
  bench.run_samples(10);
  bench.can.fail(hal::BusFailure::kDriverFault);
  bench.run_samples(500);
  EXPECT_EQ(bench.controller->transmit_queue().waiting(), 0);
  EXPECT_GE(bench.controller->transmit_queue().given_up(), 10u);
  bench.can.fail(hal::BusFailure::kNone);
  const size_t beats = bench.can.count(kHeartbeatId);
  bench.run_samples(200);
  EXPECT_EQ(bench.can.count(kHeartbeatId), beats + 2);
}

TEST(BusFaults, DriveIsNotStoppedByTheBusAlone) {
  Bench bench(bench::driving());
  bench.step();
  bench.controller->start();
  bench.run_samples(50);
  bench.can.fail(hal::BusFailure::kDown);
  bench.run_samples(500);
  EXPECT_TRUE(bench.relay.active());
  bench.stop_line.pulse(0);
  bench.run_sample();
  EXPECT_TRUE(bench.dead());
  bench.can.fail(hal::BusFailure::kNone);
  bench.run_samples(50);
  EXPECT_EQ(told(bench, 0xFF01), 1u);  // told when the bus is back
}

// Frames that the driver dropped because the program came late: an emergency frame with their number, once for each
// change.
TEST(BusFaults, WhatWasFetchedTooLateIsTold) {
  bench::Bench bench(bench::listening());
  bench.run_samples(1100);
  const size_t before = bench.can.count(0x081);
  bench.can.overflow(3);
  bench.source.overflow(4);
  bench.run_samples(1100);
  ASSERT_EQ(bench.can.count(0x081), before + 1);
  const hal::CanFrame& emergency = *bench.can.last(0x081);
  EXPECT_EQ(emergency.data[0] | emergency.data[1] << 8, 0x8110);
  EXPECT_EQ(emergency.data[4], 7);
  bench.run_samples(2200);
  EXPECT_EQ(bench.can.count(0x081), before + 1);
}

}  // namespace
