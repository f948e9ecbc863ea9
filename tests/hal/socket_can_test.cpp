// SocketCAN against the kernel. Where the kernel has no CAN the answer must say so; where there is a vcan0 (the
// emulated boards), frames go there and back.
#include "hal/linux/can/socket_can.hpp"

#include <gtest/gtest.h>
#include <net/if.h>
#include <poll.h>
#include <sys/socket.h>

#include "hal/linux/system/monotonic_clock.hpp"

namespace {

bool kernel_has_can() {
  const hal::FileDescriptor socket(::socket(PF_CAN, SOCK_RAW, 1));
  return static_cast<bool>(socket);
}

hal::CanResult wait_and_receive(hal::SocketCan& bus, hal::CanFrame& frame) {
  pollfd waiting{bus.descriptor(), POLLIN, 0};
  ::poll(&waiting, 1, 1000);
  return bus.receive(frame);
}

TEST(SocketCan, SaysWhatIsMissing) {
  hal::SocketCan bus;
  const std::string answer = bus.open("nocan7", {});
  if (kernel_has_can())
    EXPECT_NE(answer.find("no interface \"nocan7\""), std::string::npos) << answer;
  else
    EXPECT_NE(answer.find("no CAN sockets"), std::string::npos) << answer;
  hal::CanFrame frame;
  EXPECT_NE(bus.send(frame), hal::CanResult::kDone);
  EXPECT_NE(bus.receive(frame), hal::CanResult::kDone);
}

TEST(SocketCan, RefusesNamesThatAreNone) {
  hal::SocketCan bus;
  EXPECT_NE(bus.open("", {}).find("1 to 15 characters"), std::string::npos);
  EXPECT_NE(bus.open("a_name_that_is_far_too_long", {}).find("1 to 15 characters"), std::string::npos);
}

class OnVcan : public testing::Test {
 protected:
  void SetUp() override {
    if (::if_nametoindex("vcan0") == 0) GTEST_SKIP() << "this machine has no vcan0";
  }
};

TEST_F(OnVcan, FramesArriveWithTheTimeOfTheirReception) {
  hal::SocketCan sender, receiver;
  ASSERT_EQ(sender.open("vcan0", {}), "");
  ASSERT_EQ(receiver.open("vcan0", {}), "");
  hal::CanFrame out, in;
  out.id = 0x1A1;
  out.length = 2;
  out.data[1] = 0x55;
  EXPECT_EQ(receiver.receive(in), hal::CanResult::kEmpty);
  const uint64_t before_ns = hal::read_clock_ns(CLOCK_MONOTONIC);
  ASSERT_EQ(sender.send(out), hal::CanResult::kDone);
  ASSERT_EQ(wait_and_receive(receiver, in), hal::CanResult::kDone);
  const uint64_t after_ns = hal::read_clock_ns(CLOCK_MONOTONIC);
  EXPECT_EQ(in.id, 0x1A1u);
  EXPECT_EQ(in.length, 2);
  EXPECT_EQ(in.data[1], 0x55);
  EXPECT_GE(in.time_ns + 100000, before_ns);  // the clocks are read one after the other: 100 us of grace
  EXPECT_LE(in.time_ns, after_ns + 100000);
}

TEST_F(OnVcan, FiltersAndFdFrames) {
  hal::SocketCan sender, receiver;
  hal::SocketCan::Options fd;
  fd.fd = true;
  const uint32_t ids[] = {0x201};
  ASSERT_TRUE(receiver.receive_only(ids, 1));
  ASSERT_EQ(sender.open("vcan0", fd), "");
  ASSERT_EQ(receiver.open("vcan0", fd), "");
  hal::CanFrame out, in;
  out.fd = true;
  out.length = 64;
  out.data[63] = 9;
  out.id = 0x200;
  ASSERT_EQ(sender.send(out), hal::CanResult::kDone);
  out.id = 0x201;
  ASSERT_EQ(sender.send(out), hal::CanResult::kDone);
  ASSERT_EQ(wait_and_receive(receiver, in), hal::CanResult::kDone);
  EXPECT_EQ(in.id, 0x201u);
  EXPECT_TRUE(in.fd);
  EXPECT_EQ(in.data[63], 9);
  EXPECT_EQ(receiver.receive(in), hal::CanResult::kEmpty);
  EXPECT_EQ(receiver.counters().received, 1u);
}

TEST_F(OnVcan, ErrorFramesReachTheSocket) {
  hal::SocketCan sender, receiver;
  ASSERT_EQ(sender.open("vcan0", {}), "");
  ASSERT_EQ(receiver.open("vcan0", {}), "");
  hal::CanFrame out, in;
  out.error = true;
  out.id = 0x40;  // bus-off
  out.length = 8;
  ASSERT_EQ(sender.send(out), hal::CanResult::kDone);
  ASSERT_EQ(wait_and_receive(receiver, in), hal::CanResult::kDone);
  EXPECT_TRUE(in.error);
  EXPECT_EQ(in.id, 0x40u);
  EXPECT_EQ(receiver.counters().error_frames, 1u);
}

TEST(FramesInFlight, TwoAtATime) {
  hal::FramesInFlight frames;
  EXPECT_FALSE(frames.full());
  frames.sent(1), frames.sent(2);
  EXPECT_TRUE(frames.full());
  frames.came_back();
  EXPECT_FALSE(frames.full());
  frames.came_back(), frames.came_back();  // one too many changes nothing
  frames.sent(3);
  EXPECT_FALSE(frames.full());
}

// A dead bus gives nothing back; only a bus that lives, or a driver that says so, frees what was dropped.
TEST(FramesInFlight, DroppedOnesAreForgottenWhenTheBusIsSeenToLive) {
  constexpr uint64_t kSecond_ns = 1000000000;
  hal::FramesInFlight frames;
  frames.sent(kSecond_ns), frames.sent(kSecond_ns + 1);
  frames.bus_lives(kSecond_ns + hal::FramesInFlight::kDropped_ns);  // they may still be on their way
  EXPECT_TRUE(frames.full());
  frames.bus_lives(kSecond_ns + hal::FramesInFlight::kDropped_ns + 2);
  EXPECT_FALSE(frames.full());
  frames.sent(2 * kSecond_ns), frames.sent(2 * kSecond_ns);
  EXPECT_TRUE(frames.full());
  frames.dropped();
  EXPECT_FALSE(frames.full());
}

// The kernel gives a socket its frames back: until then there are no more than two, and none of them is received.
TEST_F(OnVcan, FramesThatAreConfirmedWaitForThoseBeforeThem) {
  hal::SocketCan sender, receiver;
  hal::SocketCan::Options options;
  options.confirmed_id = 0x181;
  const uint32_t ids[] = {0x000};
  ASSERT_TRUE(sender.receive_only(ids, 1));
  ASSERT_EQ(sender.open("vcan0", options), "");
  ASSERT_EQ(receiver.open("vcan0", {}), "");
  hal::CanFrame drive, other, in;
  drive.id = 0x181, other.id = 0x182;
  for (int round = 0; round < 10; ++round) {
    ASSERT_EQ(sender.send(drive), hal::CanResult::kDone) << round;
    ASSERT_EQ(sender.send(drive), hal::CanResult::kDone) << round;
    EXPECT_EQ(sender.send(drive), hal::CanResult::kQueueFull) << round;
    EXPECT_EQ(sender.send(other), hal::CanResult::kDone) << round;
    for (int i = 0; i < 3; ++i) ASSERT_EQ(wait_and_receive(receiver, in), hal::CanResult::kDone) << round;
    EXPECT_EQ(wait_and_receive(sender, in), hal::CanResult::kEmpty) << round;
  }
  EXPECT_EQ(sender.counters().received, 0u);
}

}  // namespace
