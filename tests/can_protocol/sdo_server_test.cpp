// Requests as a CANopen master sends them, answers worked out from CiA 301.
#include "firmware/can_protocol/streams/sdo_server.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <random>
#include <vector>

namespace firmware {
namespace {

using Bytes = std::vector<int>;

// 2000.0 a number of four bytes, 2001.0 a text of eleven characters, 2002.0 two bytes to write, 2003.0 takes its time.
struct Objects final : ObjectDictionary {
  SdoAbort read(uint16_t index, uint8_t subindex, uint8_t (&bytes)[kLongestObject], uint8_t& size) override {
    const char text[] = "rig damping";
    if (index < 0x2000 || index > 0x2001) return SdoAbort::kNoObject;
    if (subindex != 0) return SdoAbort::kNoSubindex;
    size = index == 0x2000 ? 4 : 11;
    for (int i = 0; i < size; ++i) bytes[i] = static_cast<uint8_t>(index == 0x2000 ? 0x11 * (i + 1) : text[i]);
    return SdoAbort::kNone;
  }
  SdoAbort write(uint16_t index, uint8_t, uint32_t value, uint8_t size) override {
    if (index == 0x2003) return SdoAbort::kPending;
    if (index != 0x2002) return SdoAbort::kReadOnly;
    if (size != 2) return SdoAbort::kLength;
    written = value;
    return SdoAbort::kNone;
  }
  uint32_t written = 0;
};

CanFrame request(uint32_t id, std::initializer_list<int> bytes) {
  CanFrame message;
  message.id = id;
  for (int byte : bytes) message.data[message.length++] = static_cast<uint8_t>(byte);
  return message;
}

Bytes bytes_of(const CanFrame& message) { return Bytes(message.data, message.data + message.length); }

class SdoServerTest : public ::testing::Test {
 protected:
  Bytes answer(std::initializer_list<int> bytes) {
    CanFrame reply;
    EXPECT_TRUE(server_.answer(request(0x602, bytes), 2, reply));
    EXPECT_EQ(reply.id, 0x582u);
    return bytes_of(reply);
  }
  Objects objects_;
  SdoServer server_{objects_};
};

TEST_F(SdoServerTest, ReadsNumbersAndTexts) {
  EXPECT_EQ(answer({0x40, 0x00, 0x20, 0, 0, 0, 0, 0}), (Bytes{0x43, 0x00, 0x20, 0, 0x11, 0x22, 0x33, 0x44}));
  // 11 characters: announced by 0x41 with their number, then 7 (toggle 0) and 4 (toggle 1: 0x10; 3 unused: 3 << 1;
  // last: 1).
  EXPECT_EQ(answer({0x40, 0x01, 0x20, 0, 0, 0, 0, 0}), (Bytes{0x41, 0x01, 0x20, 0, 11, 0, 0, 0}));
  EXPECT_EQ(answer({0x60, 0, 0, 0, 0, 0, 0, 0}), (Bytes{0x00, 'r', 'i', 'g', ' ', 'd', 'a', 'm'}));
  EXPECT_EQ(answer({0x70, 0, 0, 0, 0, 0, 0, 0}), (Bytes{0x17, 'p', 'i', 'n', 'g', 0, 0, 0}));
  // The transfer is over: another segment request is an unknown command (0x05040001).
  EXPECT_EQ(answer({0x60, 0, 0, 0, 0, 0, 0, 0}), (Bytes{0x80, 0, 0, 0, 0x01, 0x00, 0x04, 0x05}));
}

TEST_F(SdoServerTest, WritesWhatIsTwoBytesLong) {
  EXPECT_EQ(answer({0x2B, 0x02, 0x20, 0, 0xF4, 0x01, 0xEE, 0xEE}), (Bytes{0x60, 0x02, 0x20, 0, 0, 0, 0, 0}));
  EXPECT_EQ(objects_.written, 500u);  // the unused bytes do not count
  EXPECT_EQ(answer({0x23, 0x02, 0x20, 0, 0xF4, 1, 0, 0}), (Bytes{0x80, 0x02, 0x20, 0, 0x10, 0x00, 0x07, 0x06}));
  EXPECT_EQ(answer({0x2B, 0x05, 0x20, 0, 0, 0, 0, 0}), (Bytes{0x80, 0x05, 0x20, 0, 0x02, 0x00, 0x01, 0x06}));
}

// The answer to a write that takes its time is that write's own, whatever is asked for meanwhile.
TEST_F(SdoServerTest, AnswersALongWriteWhenItIsDone) {
  CanFrame reply;
  EXPECT_FALSE(server_.answer(request(0x602, {0x23, 0x03, 0x20, 7, 1, 2, 3, 4}), 2, reply));
  EXPECT_EQ(answer({0x40, 0x00, 0x20, 0, 0, 0, 0, 0})[0], 0x43);  // reading goes on
  // Another write: 0x08000022, not in this state.
  EXPECT_EQ(answer({0x2B, 0x02, 0x20, 0, 9, 0, 0, 0}), (Bytes{0x80, 0x02, 0x20, 0, 0x22, 0, 0, 0x08}));
  EXPECT_EQ(objects_.written, 0u);
  EXPECT_EQ(bytes_of(server_.complete(SdoAbort::kNone)), (Bytes{0x60, 0x03, 0x20, 7, 0, 0, 0, 0}));
  EXPECT_EQ(answer({0x2B, 0x02, 0x20, 0, 9, 0, 0, 0})[0], 0x60);
}

// Whatever a client sends, each request gets at most one answer, an abort or a value (and the sanitizers see nothing).
TEST_F(SdoServerTest, RandomRequestsAreAnswered) {
  std::mt19937_64 random(7);
  const int commands[] = {0x40, 0x60, 0x70, 0x23, 0x2B, 0x2F, 0x22, 0x80};
  int values = 0;
  for (int i = 0; i < 50000; ++i) {
    const int command = random() % 4 == 0 ? static_cast<int>(random() % 256) : commands[random() % 8];
    const int index = 0x2000 + static_cast<int>(random() % 3);
    CanFrame reply;
    const bool answered = server_.answer(
        request(0x602, {command, index & 255, index >> 8, static_cast<int>(random() % 2), 1, 0, 0, 0}), 2, reply);
    ASSERT_EQ(answered, command != 0x80);
    if (answered) values += reply.data[0] != 0x80;
  }
  EXPECT_GT(values, 1000);
}

TEST_F(SdoServerTest, LeavesOtherFramesAlone) {
  CanFrame reply;
  EXPECT_FALSE(server_.answer(request(0x601, {0x40, 0, 0x20, 0, 0, 0, 0, 0}), 2, reply));  // another node
  EXPECT_FALSE(server_.answer(request(0x602, {0x40, 0, 0x20, 0, 0, 0, 0}), 2, reply));     // seven bytes
  EXPECT_FALSE(server_.answer(request(0x602, {0x80, 0, 0x20, 0, 0, 0, 0, 8}), 2, reply));  // an abort
}

}  // namespace
}  // namespace firmware
