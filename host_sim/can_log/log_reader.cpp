#include "host_sim/can_log/log_reader.hpp"

namespace can_log {
namespace {

constexpr size_t kLongestLine = 1024;  // a screen line of a CAN FD frame has about 250 characters

}  // namespace

// Keeps no more than kLongestLine characters, so that a binary file by mistake does not fill the memory.
bool LogReader::next_line() {
  text_.clear();
  too_long_ = false;
  std::streambuf* buffer = input_.rdbuf();
  int c = buffer == nullptr ? EOF : buffer->sbumpc();
  if (c == EOF) return false;
  for (; c != EOF && c != '\n'; c = buffer->sbumpc()) {
    if (text_.size() < kLongestLine) {
      text_ += static_cast<char>(c);
    } else {
      too_long_ = true;
    }
  }
  ++line_;
  return true;
}

bool LogReader::next(LogEntry& entry) {
  while (next_line()) {
    if (!too_long_ && (parse_line(text_, entry) || asc_.parse(text_, entry))) {
      ++frames_;
      return true;
    }
    if (text_.find_first_not_of(" \t\r") == std::string::npos && !too_long_) continue;
    if (skipped_++ == 0) first_skipped_line_ = line_;
  }
  return false;
}

}  // namespace can_log
