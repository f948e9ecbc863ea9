// One line of a candump text to a frame and back. Written lines are those of `candump -L`:
//   (1700000000.000001) vcan0 191#0011223344556677      (ten digits of seconds, six of microseconds, one blank, upper
//   case)
// Read are also: nine decimals, several blanks, a direction ` T` or ` R` at the end, 8-digit identifiers (29 bits, or
// an error frame where bit 29 is set), `##` CAN FD frames, `#R` remote frames, `_9` to `_F` length codes, and what
// candump prints on a screen (`  vcan0  123   [8]  11 22 ...`, with or without a time in front).
#pragma once
#include <string>
#include <string_view>

#include "firmware/can_protocol/can_frame.hpp"
#include "hal/interface/can_bus.hpp"

namespace can_log {

struct LogEntry {
  bool has_time = false;  // the screen form may have none
  std::string interface;
  hal::CanFrame frame;  // time_ns is the log's time
};

// False where the line is no frame; entry is then undefined.
bool parse_line(std::string_view line, LogEntry& entry);
bool parse_log_line(std::string_view line, LogEntry& entry);     // `candump -L`
bool parse_screen_line(std::string_view line, LogEntry& entry);  // `candump`

// Without the newline. Times beyond 9999999999 s are written with more digits.
std::string format_line(const hal::CanFrame& frame, std::string_view interface);

hal::CanFrame to_frame(const firmware::CanFrame& message, uint64_t time_ns);
firmware::CanFrame to_message(const hal::CanFrame& frame);

}  // namespace can_log
