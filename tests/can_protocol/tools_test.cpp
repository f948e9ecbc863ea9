// A written log in the hands of those who know the format best: can-utils and tshark. Skipped where they are not
// installed.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "firmware/can_protocol/messages/packing.hpp"
#include "firmware/can_protocol/streams/estimate_frames.hpp"
#include "host_sim/can_log/log_reader.hpp"
#include "host_sim/can_log/log_writer.hpp"

namespace can_log {
namespace {

struct Output {
  int status = -1;
  std::string text;
};

Output run(const std::string& command) {
  Output result;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return result;
  char buffer[4096];
  for (size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) result.text.append(buffer, n);
  result.status = pclose(pipe);
  return result;
}

bool installed(const std::string& program) { return run("command -v " + program).status == 0; }

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream input(text);
  for (std::string line; std::getline(input, line);) lines.push_back(line);
  return lines;
}

class Tools : public ::testing::Test {
 protected:
  // One frame of each kind of the table, 1 ms apart.
  Tools() : path_(::testing::TempDir() + "can_protocol_tools_" + std::to_string(getpid()) + ".log") {
    std::ofstream file(path_);
    LogWriter writer(file, "vcan0", kSimulatedEpoch_s);
    uint64_t time_ns = 0;
    for (const firmware::can::FrameDescription* frame : firmware::can::kFrames) {
      firmware::CanFrame message = firmware::can::empty_frame(*frame, 1);
      for (int i = 0; i < 64 && i < message.length; ++i)
        message.data[i] = static_cast<uint8_t>(16 * i + message.id % 16);
      writer.write(message, time_ns += 1000000);
      expected_.push_back(message);
    }
  }
  ~Tools() override { std::remove(path_.c_str()); }
  std::string path_;
  std::vector<firmware::CanFrame> expected_;
};

TEST_F(Tools, Log2ascAndBackGivesTheSameFrames) {
  if (!installed("log2asc") || !installed("asc2log"))
    GTEST_SKIP() << "log2asc and asc2log (Debian: can-utils) are not installed";
  const Output asc = run("log2asc -I " + path_ + " vcan0");
  ASSERT_EQ(asc.status, 0);
  const Output log = run("log2asc -I " + path_ + " vcan0 | asc2log");
  ASSERT_EQ(log.status, 0);
  std::istringstream input(log.text);
  LogReader reader(input);
  LogEntry entry;
  size_t count = 0;
  while (reader.next(entry)) {
    ASSERT_LT(count, expected_.size());
    const firmware::CanFrame message = to_message(entry.frame);
    EXPECT_EQ(message.id, expected_[count].id);
    EXPECT_EQ(message.fd, expected_[count].fd) << std::hex << message.id;
    EXPECT_EQ(std::string(message.data, message.data + message.length),
              std::string(expected_[count].data, expected_[count].data + expected_[count].length))
        << std::hex << message.id;
    ++count;
  }
  EXPECT_EQ(count, expected_.size());
  EXPECT_EQ(reader.skipped(), 0u);
}

TEST_F(Tools, TsharkReadsEveryFrame) {
  if (!installed("tshark")) GTEST_SKIP() << "tshark is not installed";
  const Output output = run("tshark -r " + path_ + " -T fields -e can.id -e can.len 2>/dev/null");
  ASSERT_EQ(output.status, 0);
  const std::vector<std::string> lines = lines_of(output.text);
  ASSERT_EQ(lines.size(), expected_.size());
  for (size_t i = 0; i < lines.size(); ++i) {
    std::istringstream fields(lines[i]);
    std::string id;
    int length = -1;
    fields >> id >> length;
    EXPECT_EQ(std::stoul(id, nullptr, 0), expected_[i].id) << lines[i];
    EXPECT_EQ(length, expected_[i].length) << lines[i];
  }
}

}  // namespace
}  // namespace can_log
