// candump text: what is written, character by character, and every form that is read.
#include "host_sim/can_log/candump_line.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <sstream>

#include "host_sim/can_log/log_reader.hpp"
#include "host_sim/can_log/log_writer.hpp"

namespace can_log {
namespace {

hal::CanFrame frame(uint32_t id, std::initializer_list<int> bytes, uint64_t time_ns = 0) {
  hal::CanFrame result;
  result.id = id;
  for (int byte : bytes) result.data[result.length++] = static_cast<uint8_t>(byte);
  result.time_ns = time_ns;
  return result;
}

TEST(Written, CharacterByCharacter) {
  hal::CanFrame f = frame(0x12, {0xAB, 0x01}, 1700000000000001999ull);  // 1.999 us: digits beyond are cut off
  EXPECT_EQ(format_line(f, "vcan0"), "(1700000000.000001) vcan0 012#AB01");
  f.extended = true;
  EXPECT_EQ(format_line(f, "can1"), "(1700000000.000001) can1 00000012#AB01");
  f.extended = false;
  f.fd = true;
  f.flags = 1;
  EXPECT_EQ(format_line(f, "can1"), "(1700000000.000001) can1 012##1AB01");
  EXPECT_EQ(format_line(frame(0x80, {}), "vcan0"), "(0000000000.000000) vcan0 080#");
  f = frame(0x04, {0, 4, 0, 0, 0, 0, 0, 0});
  f.error = true;
  EXPECT_EQ(format_line(f, "can0"), "(0000000000.000000) can0 20000004#0004000000000000");
  f = frame(0x701, {});
  f.remote = true;
  EXPECT_EQ(format_line(f, "can0"), "(0000000000.000000) can0 701#R");
  f.length = 1;
  EXPECT_EQ(format_line(f, "can0"), "(0000000000.000000) can0 701#R1");
}

TEST(Written, WithTheEpochOfSimulatedTime) {
  std::ostringstream text;
  LogWriter writer(text, "vcan0", kSimulatedEpoch_s);
  writer.write(frame(0x80, {}, 1500000));
  EXPECT_EQ(text.str(), "(1000000000.001500) vcan0 080#\n");
  EXPECT_EQ(writer.frames(), 1u);
  EXPECT_EQ(simulated_line(frame(0x80, {}, 1500000), "vcan0") + "\n", text.str());
}

struct Readable {
  const char* line;
  uint32_t id;
  int length;
  int last_byte;  // -1: none
  uint64_t time_ns;
  const char* kind;  // "", "extended", "error", "remote", "fd"
};

TEST(Read, EveryFormOfAFrame) {
  const Readable table[] = {
      {"(1700000000.000001) vcan0 123#0A", 0x123, 1, 0x0A, 1700000000000001000ull, ""},
      {"(1700000000.000000001) can0 123#0a", 0x123, 1, 0x0A, 1700000000000000001ull, ""},
      {"(1700000000.2) can0 123#", 0x123, 0, -1, 1700000000200000000ull, ""},
      {"(1700000000.000001)    can0   123#00   R", 0x123, 1, 0, 1700000000000001000ull, ""},
      {"(1700000000.000001) can0 123#00 T\r\n", 0x123, 1, 0, 1700000000000001000ull, ""},
      {"  (0.5) can0 7FF#1122334455667788", 0x7FF, 8, 0x88, 500000000ull, ""},
      {"(0.5) can0 12345678#11", 0x12345678, 1, 0x11, 500000000ull, "extended"},
      {"(0.5) can0 00000012#11", 0x12, 1, 0x11, 500000000ull, "extended"},
      {"(0.5) can0 20000040#0000000000000000", 0x40, 8, 0, 500000000ull, "error"},
      {"(0.5) can0 123#R", 0x123, 0, -1, 500000000ull, "remote"},
      {"(0.5) can0 123#R8", 0x123, 8, -1, 500000000ull, "remote"},
      {"(0.5) can0 123##1112233", 0x123, 3, 0x33, 500000000ull, "fd"},
      {"(0.5) can0 123##5", 0x123, 0, -1, 500000000ull, "fd"},
      {"(0.5) can0 123#1122334455667788_9", 0x123, 8, 0x88, 500000000ull, ""},
      {"(0.5) can0 123#1122334455667788_F R", 0x123, 8, 0x88, 500000000ull, ""},
      {"(0.5) can0 123#11.22.33", 0x123, 3, 0x33, 500000000ull, ""},
      {"  vcan0  123   [8]  11 22 33 44 55 66 77 88", 0x123, 8, 0x88, 0, ""},
      {"  vcan0  123   [0] ", 0x123, 0, -1, 0, ""},
      {"  vcan0  12345678   [2]  11 22", 0x12345678, 2, 0x22, 0, "extended"},
      {"  vcan0  123  [08]  11 22 33 44 55 66 77 88", 0x123, 8, 0x88, 0, "fd"},
      {"  vcan0  123   [3]  remote request", 0x123, 3, -1, 0, "remote"},
      {"  can0  20000004   [8]  00 04 00 00 00 00 00 07   ERRORFRAME", 0x04, 8, 7, 0, "error"},
      {" (1700000000.000001)  vcan0  123   [2]  41 42   'AB'", 0x123, 2, 0x42, 1700000000000001000ull, ""},
      {"  vcan0  RX - -  123   [2]  41 42", 0x123, 2, 0x42, 0, ""},
      {"  vcan0  TX B E  123  [02]  41 42", 0x123, 2, 0x42, 0, "fd"},
  };
  for (const Readable& row : table) {
    LogEntry entry;
    ASSERT_TRUE(parse_line(row.line, entry)) << row.line;
    EXPECT_EQ(entry.frame.id, row.id) << row.line;
    EXPECT_EQ(entry.frame.length, row.length) << row.line;
    if (row.last_byte >= 0) {
      EXPECT_EQ(entry.frame.data[row.length - 1], row.last_byte) << row.line;
    }
    EXPECT_EQ(entry.frame.time_ns, row.time_ns) << row.line;
    EXPECT_EQ(entry.frame.extended, std::strcmp(row.kind, "extended") == 0) << row.line;
    EXPECT_EQ(entry.frame.error, std::strcmp(row.kind, "error") == 0) << row.line;
    EXPECT_EQ(entry.frame.remote, std::strcmp(row.kind, "remote") == 0) << row.line;
    EXPECT_EQ(entry.frame.fd, std::strcmp(row.kind, "fd") == 0) << row.line;
  }
}

TEST(Read, WhatIsNoFrameIsRefused) {
  const char* table[] = {
      "",
      "noise",
      "# a comment",
      "(1700000000.000001) vcan0",
      "(1700000000.000001) vcan0 123",
      "(1700000000) vcan0 123#00",
      "(x.y) vcan0 123#00",
      "1700000000.000001 vcan0 123#00",
      "(1.0) vcan0 12#00",
      "(1.0) vcan0 1234#00",
      "(1.0) vcan0 800#00",  // three digits, but more than 11 bits
      "(1.0) vcan0 123#0",
      "(1.0) vcan0 123#0G",
      "(1.0) vcan0 123#112233445566778899",
      "(1.0) vcan0 123#00 X",
      "(1.0) vcan0 123##",
      "(1.0) vcan0 123##G00",
      "(1.0) vcan0 123#R9",
      "(1.0) vcan0 123#00_9",
      "(1.0) vcan0 123#00 T R",
      "  vcan0  123   [9]  11 22 33 44 55 66 77 88 99",
      "  vcan0  123   [2]  11",
      "  vcan0  123   [2]  11 22 33",
      "  vcan0  123   [65]  11",
      "vcan0 123 8 11 22",
      "(99999999999999999999.0) vcan0 123#00",
  };
  for (const char* line : table) {
    LogEntry entry;
    EXPECT_FALSE(parse_line(line, entry)) << line;
  }
  LogEntry entry;
  EXPECT_FALSE(parse_line("(1.0) vcan0 123##0" + std::string(130, '0'), entry));  // 65 bytes
  EXPECT_TRUE(parse_line("(1.0) vcan0 123##0" + std::string(128, '0'), entry));
}

TEST(Read, CountsWhatItSkips) {
  std::istringstream text("(1.0) vcan0 123#00\nnoise\n\n   \n(2.0) vcan0 123#01\n" + std::string(5000, 'x') + "\n" +
                          "(3.0) vcan0 123#02" + std::string(5000, ' ') + "\n(4.0) vcan0 123#03");
  LogReader reader(text);
  LogEntry entry;
  int last = -1;
  while (reader.next(entry)) last = entry.frame.data[0];
  EXPECT_EQ(reader.frames(), 3u);
  EXPECT_EQ(reader.skipped(), 3u);  // the word, and the two lines that are longer than any frame
  EXPECT_EQ(reader.first_skipped_line(), 2u);
  EXPECT_EQ(last, 3);
}

TEST(WrittenAndRead, RandomFramesComeBack) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 20000; ++i) {
    hal::CanFrame f;
    const int kind = static_cast<int>(random() % 5);
    f.extended = kind == 1;
    f.error = kind == 2;
    f.remote = kind == 3;
    f.fd = kind == 4;
    f.id = static_cast<uint32_t>(random()) & (f.extended || f.error ? 0x1FFFFFFFu : 0x7FFu);
    f.flags = f.fd ? static_cast<uint8_t>(random() % 4) : uint8_t{0};
    f.length = static_cast<uint8_t>(random() % (f.fd ? 65 : 9));
    if (!f.remote)
      for (int k = 0; k < f.length; ++k) f.data[k] = static_cast<uint8_t>(random());
    f.time_ns = random() % 9999999999999999ull * 1000;
    LogEntry entry;
    const std::string line = format_line(f, "vcan0");
    ASSERT_TRUE(parse_line(line, entry)) << line;
    ASSERT_EQ(format_line(entry.frame, entry.interface), line);
    ASSERT_EQ(std::memcmp(entry.frame.data, f.data, sizeof f.data), 0);
    ASSERT_EQ(entry.frame.time_ns, f.time_ns);
  }
}

// Lines with a few characters changed: read or refused, never out of bounds (for the sanitizers).
TEST(WrittenAndRead, BrokenLinesAreSurvived) {
  std::mt19937_64 random(5);
  const std::string lines[] = {"(1700000000.000001) vcan0 123#1122334455667788_F R", "(1.5) can0 12345678##1112233 T",
                               "  (1.5)  can0  TX B E  123  [08]  11 22 33 44 55 66 77 88   '.....'"};
  int taken = 0;
  for (int i = 0; i < 100000; ++i) {
    std::string line = lines[random() % 3];
    for (uint64_t k = random() % 4 + 1; k > 0; --k) line[random() % line.size()] = static_cast<char>(random());
    if (random() % 4 == 0) line.resize(random() % line.size());
    LogEntry entry;
    if (parse_line(line, entry)) {
      ++taken;
      EXPECT_LE(entry.frame.length, 64);
    }
  }
  EXPECT_GT(taken, 100);
}

}  // namespace
}  // namespace can_log
