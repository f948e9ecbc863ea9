// A controller compiled for buses without CAN FD (FIRMWARE_CAN_FD 0): frames of up to 8 bytes alone find room.
#include <gtest/gtest.h>

#include <algorithm>

#include "firmware/can_protocol/frame_table.hpp"
#include "tests/rig_controller/bench.hpp"

namespace {

using bench::Bench;
using firmware::CanFrame;

CanFrame frame(uint32_t id, uint8_t length) {
  CanFrame made;
  made.id = id;
  made.length = length;
  made.fd = length > 8;
  for (uint8_t i = 0; i < length; ++i) made.data[i] = static_cast<uint8_t>(id + i);
  return made;
}

// 8 bytes go out as they came; 9 are counted as given up and hurt no other frame.
TEST(ClassicCan, ALongFrameIsGivenUp) {
  static_assert(!firmware::kSendsFd, "this test is compiled with FIRMWARE_CAN_FD 0");
  hal::ManualClock clock;
  hal::FakeCanBus bus(clock);
  firmware::TransmitQueue queue;
  queue.push(frame(0x201, 8));
  queue.push(frame(0x200, 9));
  queue.push(frame(0x202, 64));
  EXPECT_EQ(queue.waiting(), 1);
  EXPECT_EQ(queue.given_up(), 2u);
  queue.flush(bus);
  ASSERT_EQ(bus.sent().size(), 1u);
  EXPECT_EQ(bus.sent()[0].id, 0x201u);
  EXPECT_EQ(bus.sent()[0].length, 8);
  for (uint8_t i = 0; i < 8; ++i) EXPECT_EQ(bus.sent()[0].data[i], 0x01 + i);
}

// The queue is the room that the macro saves: 56 bytes less for each of the frames that wait.
TEST(ClassicCan, TheQueueIsSmaller) {
  EXPECT_LT(sizeof(firmware::TransmitQueue), 24u * firmware::TransmitQueue::kCapacity);
}

TEST(ClassicCan, EstimatesGoOutInShortFrames) {
  Bench bench(bench::listening());
  bench.run_samples(3000);
  EXPECT_FALSE(bench.controller->latched_alarm());
  const uint8_t node = bench.controller->node().node;
  EXPECT_GT(bench.can.count(firmware::can::frame_id(firmware::can::kEstimate.ids, node)), 0u);
  const auto& sent = bench.can.sent();
  EXPECT_TRUE(std::all_of(sent.begin(), sent.end(), [](const CanFrame& each) { return each.length <= 8 && !each.fd; }));
  EXPECT_EQ(bench.controller->transmit_queue().given_up(), 0u);
}

// Stored for a board that has CAN FD: told, not sent in halves.
TEST(ClassicCan, AConfigurationForFdIsRefused) {
  firmware::ControllerConfiguration configuration = bench::listening();
  configuration.node.can_fd = true;
  Bench bench(configuration);
  bench.step();
  EXPECT_EQ(bench.controller->latched_alarm().cause, firmware::AlarmCause::kConfiguration);
  EXPECT_FALSE(bench.controller->reset());
}

}  // namespace
