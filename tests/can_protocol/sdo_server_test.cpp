// Requests as a CANopen master sends them, answers worked out from CiA 301.
#include "firmware/can_protocol/sdo_server.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <random>
#include <string>
#include <vector>

namespace firmware {
namespace {

using Bytes = std::vector<int>;

CanMessage request(uint32_t id, std::initializer_list<int> bytes) {
  CanMessage message;
  message.id = id;
  for (int byte : bytes) message.data[message.length++] = static_cast<uint8_t>(byte);
  return message;
}

Bytes bytes_of(const CanMessage& message) { return Bytes(message.data, message.data + message.length); }

class Sdo : public ::testing::Test {
 protected:
  Sdo() : server_(2, values()) {}
  static ObjectValues values() {
    ObjectValues values;
    values.device_type = 0x00020192;
    values.serial_number = 77;
    values.device_name = "rig damping";  // 11 characters: two segments
    values.hardware_version = "A1";
    values.firmware_version = "0.1.0";
    return values;
  }
  Bytes answer(std::initializer_list<int> bytes) {
    const SdoResult result = server_.handle(request(0x602, bytes));
    EXPECT_TRUE(result.handled);
    EXPECT_TRUE(result.has_reply);
    EXPECT_EQ(result.reply.id, 0x582u);
    return bytes_of(result.reply);
  }
  SdoServer server_;
};

TEST_F(Sdo, ReadsNumbers) {
  // 0x40 index subindex -> 0x43 four bytes, 0x4B two, 0x4F one.
  EXPECT_EQ(answer({0x40, 0x00, 0x10, 0, 0, 0, 0, 0}), (Bytes{0x43, 0x00, 0x10, 0, 0x92, 0x01, 0x02, 0x00}));
  EXPECT_EQ(answer({0x40, 0x05, 0x10, 0, 0, 0, 0, 0}), (Bytes{0x43, 0x05, 0x10, 0, 0x80, 0, 0, 0}));
  EXPECT_EQ(answer({0x40, 0x14, 0x10, 0, 0, 0, 0, 0}), (Bytes{0x43, 0x14, 0x10, 0, 0x82, 0, 0, 0}));
  EXPECT_EQ(answer({0x40, 0x17, 0x10, 0, 0, 0, 0, 0}), (Bytes{0x4B, 0x17, 0x10, 0, 100, 0, 0, 0}));
  EXPECT_EQ(answer({0x40, 0x01, 0x10, 0, 0, 0, 0, 0}), (Bytes{0x4F, 0x01, 0x10, 0, 0, 0, 0, 0}));
  EXPECT_EQ(answer({0x40, 0x18, 0x10, 0, 0, 0, 0, 0}), (Bytes{0x4F, 0x18, 0x10, 0, 4, 0, 0, 0}));
  EXPECT_EQ(answer({0x40, 0x18, 0x10, 4, 0, 0, 0, 0}), (Bytes{0x43, 0x18, 0x10, 4, 77, 0, 0, 0}));
}

TEST_F(Sdo, ReadsStrings) {
  // Two characters travel expedited: 0x4B 'A' '1'.
  EXPECT_EQ(answer({0x40, 0x09, 0x10, 0, 0, 0, 0, 0}), (Bytes{0x4B, 0x09, 0x10, 0, 'A', '1', 0, 0}));
  // 11 characters: announced by 0x41 with their number, then 7 (toggle 0) and 4 (toggle 1: 0x10; 3 unused: 3 << 1;
  // last: 1).
  EXPECT_EQ(answer({0x40, 0x08, 0x10, 0, 0, 0, 0, 0}), (Bytes{0x41, 0x08, 0x10, 0, 11, 0, 0, 0}));
  EXPECT_EQ(answer({0x60, 0, 0, 0, 0, 0, 0, 0}), (Bytes{0x00, 'r', 'i', 'g', ' ', 'd', 'a', 'm'}));
  EXPECT_EQ(answer({0x70, 0, 0, 0, 0, 0, 0, 0}), (Bytes{0x17, 'p', 'i', 'n', 'g', 0, 0, 0}));
  // The transfer is over: another segment request is an unknown command (0x05040001).
  EXPECT_EQ(answer({0x60, 0, 0, 0, 0, 0, 0, 0}), (Bytes{0x80, 0, 0, 0, 0x01, 0x00, 0x04, 0x05}));
}

TEST_F(Sdo, ASegmentAskedForTwiceEndsTheTransfer) {
  answer({0x40, 0x08, 0x10, 0, 0, 0, 0, 0});
  answer({0x60, 0, 0, 0, 0, 0, 0, 0});
  // Toggle bit not alternated: 0x05030000, with the object of the transfer.
  EXPECT_EQ(answer({0x60, 0, 0, 0, 0, 0, 0, 0}), (Bytes{0x80, 0x08, 0x10, 0, 0x00, 0x00, 0x03, 0x05}));
}

TEST_F(Sdo, SavesWhenTheControllerHasSaved) {
  // "save" = 73 61 76 65; the answer waits for confirm().
  const CanMessage save = request(0x602, {0x23, 0x10, 0x10, 1, 's', 'a', 'v', 'e'});
  SdoResult result = server_.handle(save);
  EXPECT_EQ(result.action, SdoAction::kSave);
  EXPECT_FALSE(result.has_reply);
  // Meanwhile: 0x08000022, not in this state.
  EXPECT_EQ(answer({0x40, 0x00, 0x10, 0, 0, 0, 0, 0}), (Bytes{0x80, 0x00, 0x10, 0, 0x22, 0, 0, 0x08}));
  EXPECT_EQ(bytes_of(server_.confirm(true)), (Bytes{0x60, 0x10, 0x10, 1, 0, 0, 0, 0}));
  // A store that fails: 0x06060000.
  EXPECT_EQ(server_.handle(save).action, SdoAction::kSave);
  EXPECT_EQ(bytes_of(server_.confirm(false)), (Bytes{0x80, 0x10, 0x10, 1, 0, 0, 0x06, 0x06}));
  result = server_.handle(request(0x602, {0x23, 0x11, 0x10, 1, 'l', 'o', 'a', 'd'}));
  EXPECT_EQ(result.action, SdoAction::kLoadDefaults);
  EXPECT_EQ(bytes_of(server_.confirm(true)), (Bytes{0x60, 0x11, 0x10, 1, 0, 0, 0, 0}));
}

TEST_F(Sdo, WritesTheHeartbeatTime) {
  const SdoResult result = server_.handle(request(0x602, {0x2B, 0x17, 0x10, 0, 0xF4, 0x01, 0, 0}));  // 500 ms
  EXPECT_EQ(result.action, SdoAction::kHeartbeatChanged);
  EXPECT_EQ(bytes_of(result.reply), (Bytes{0x60, 0x17, 0x10, 0, 0, 0, 0, 0}));
  EXPECT_EQ(server_.values().heartbeat_ms, 500);
  // 9 ms is too low (0x06090032); four bytes are the wrong length (0x06070010).
  EXPECT_EQ(answer({0x2B, 0x17, 0x10, 0, 9, 0, 0, 0}), (Bytes{0x80, 0x17, 0x10, 0, 0x32, 0x00, 0x09, 0x06}));
  EXPECT_EQ(answer({0x23, 0x17, 0x10, 0, 0xF4, 1, 0, 0}), (Bytes{0x80, 0x17, 0x10, 0, 0x10, 0x00, 0x07, 0x06}));
  EXPECT_EQ(server_.values().heartbeat_ms, 500);
}

TEST_F(Sdo, RefusesWithTheReason) {
  struct Case {
    const char* what;
    std::initializer_list<int> bytes;
    Bytes answer;
  };
  const Case cases[] = {
      {"no such object", {0x40, 0x00, 0x20, 0, 0, 0, 0, 0}, {0x80, 0x00, 0x20, 0, 0x00, 0x00, 0x02, 0x06}},
      {"no such subindex", {0x40, 0x18, 0x10, 5, 0, 0, 0, 0}, {0x80, 0x18, 0x10, 5, 0x11, 0x00, 0x09, 0x06}},
      {"read only", {0x23, 0x00, 0x10, 0, 1, 2, 3, 4}, {0x80, 0x00, 0x10, 0, 0x02, 0x00, 0x01, 0x06}},
      {"save: wrong word", {0x23, 0x10, 0x10, 1, 'S', 'A', 'V', 'E'}, {0x80, 0x10, 0x10, 1, 0x20, 0x00, 0x00, 0x08}},
      {"segmented write", {0x21, 0x17, 0x10, 0, 2, 0, 0, 0}, {0x80, 0x17, 0x10, 0, 0x01, 0x00, 0x04, 0x05}}};
  for (const Case& c : cases) EXPECT_EQ(answer(c.bytes), c.answer) << c.what;
}

// Whatever a client sends, each request gets one answer, an abort or a value (and the sanitizers see nothing).
TEST_F(Sdo, RandomRequestsAreAnswered) {
  std::mt19937_64 random(7);
  const int indices[] = {0x1000, 0x1001, 0x1005, 0x1008, 0x1009, 0x100A,
                         0x1010, 0x1011, 0x1014, 0x1017, 0x1018, 0x2000};
  const int commands[] = {0x40, 0x60, 0x70, 0x23, 0x2B, 0x2F, 0x22, 0x80};
  int values = 0;
  for (int i = 0; i < 50000; ++i) {
    const int index = indices[random() % 12];
    const int command = random() % 4 == 0 ? static_cast<int>(random() % 256) : commands[random() % 8];
    const SdoResult result =
        server_.handle(request(0x602, {command, index & 255, index >> 8, static_cast<int>(random() % 6),
                                       static_cast<int>(random() % 256), 0, 0, 0}));
    ASSERT_TRUE(result.handled);
    ASSERT_EQ(result.has_reply, command != 0x80);
    if (!result.has_reply) continue;
    ASSERT_EQ(result.reply.id, 0x582u);
    ASSERT_EQ(result.reply.length, 8);
    values += result.reply.data[0] != 0x80;
  }
  EXPECT_GT(values, 1000);
  EXPECT_GE(server_.values().heartbeat_ms, kShortestHeartbeat_ms);
}

TEST_F(Sdo, LeavesOtherFramesAlone) {
  EXPECT_FALSE(server_.handle(request(0x601, {0x40, 0, 0x10, 0, 0, 0, 0, 0})).handled);  // another node
  EXPECT_FALSE(server_.handle(request(0x602, {0x40, 0, 0x10, 0, 0, 0, 0})).handled);     // seven bytes
  const SdoResult aborted = server_.handle(request(0x602, {0x80, 0, 0x10, 0, 0, 0, 0, 8}));
  EXPECT_TRUE(aborted.handled);
  EXPECT_FALSE(aborted.has_reply);
}

}  // namespace
}  // namespace firmware
