// What candump prints on a screen:
//   (1700000000.000001)  vcan0  RX - -  123   [8]  11 22 33 44 55 66 77 88   '.."3DUfw'
// The time, the direction with its flags (-x), the blanks and the text at the end (-a) may be missing; CAN FD lengths
// have two digits, [08] to [64].
#include "host_sim/can_log/candump_line.hpp"
#include "host_sim/can_log/text_cursor.hpp"

namespace can_log {
namespace {

bool take_length(TextCursor& cursor, hal::CanFrame& frame) {
  uint64_t length = 0;
  if (!cursor.take('[')) return false;
  const int digits = cursor.take_decimal(length, 2);
  if (digits == 0 || !cursor.take(']')) return false;
  frame.fd = digits == 2;
  if (length > static_cast<uint64_t>(frame.fd ? kMaxFdBytes : kMaxClassicBytes)) return false;
  frame.length = static_cast<uint8_t>(length);
  return true;
}

// " RX - -" or " TX B E": direction, bit-rate switch, error state indicator.
void take_direction(TextCursor& cursor, hal::CanFrame& frame) {
  TextCursor ahead = cursor;
  if (!ahead.take("RX ") && !ahead.take("TX ")) return;
  ahead.take_blanks();
  if (ahead.take('B')) {
    frame.flags |= 1;
  } else if (!ahead.take('-')) {
    return;
  }
  ahead.take_blanks();
  if (ahead.take('E')) {
    frame.flags |= 2;
  } else if (!ahead.take('-')) {
    return;
  }
  ahead.take_blanks();
  cursor = ahead;
}

}  // namespace

bool parse_screen_line(std::string_view line, LogEntry& entry) {
  TextCursor cursor{line};
  entry = LogEntry();
  hal::CanFrame& frame = entry.frame;
  cursor.take_blanks();
  entry.has_time = take_time(cursor, frame.time_ns);
  cursor.take_blanks();
  entry.interface = std::string(cursor.take_word());
  if (entry.interface.empty() || !cursor.take_blanks()) return false;
  take_direction(cursor, frame);
  if (!take_id(cursor, frame.id, frame.extended, frame.error)) return false;
  cursor.take_blanks();
  if (!take_length(cursor, frame)) return false;
  cursor.take_blanks();
  if (cursor.take("remote request")) {
    frame.remote = true;
    return true;
  }
  for (int i = 0; i < frame.length; ++i) {
    uint32_t byte = 0;
    if (cursor.take_hex(byte, 2) != 2) return false;
    if (!cursor.take_blanks() && !cursor.at_end()) return false;
    frame.data[i] = static_cast<uint8_t>(byte);
  }
  return cursor.at_end() || cursor.take('\'') || cursor.take("ERRORFRAME");
}

}  // namespace can_log
