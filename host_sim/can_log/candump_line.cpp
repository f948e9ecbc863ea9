#include "host_sim/can_log/candump_line.hpp"

#include <fmt/format.h>

#include <cstring>

#include "host_sim/can_log/text_cursor.hpp"

namespace can_log {
namespace {

// Bytes in pairs of digits, an optional `.` between them as candump's relatives write it.
bool take_bytes(TextCursor& cursor, hal::CanFrame& frame, int most) {
  int count = 0;
  while (!cursor.at_end() && hex_digit(cursor.text.front()) >= 0) {
    uint32_t byte = 0;
    if (count == most || cursor.take_hex(byte, 2) != 2) return false;
    frame.data[count++] = static_cast<uint8_t>(byte);
    cursor.take('.');
  }
  frame.length = static_cast<uint8_t>(count);
  return true;
}

bool take_remote(TextCursor& cursor, hal::CanFrame& frame) {
  uint32_t length = 0;
  frame.remote = true;
  if (cursor.take_hex(length, 1) == 1 && length > kMaxClassicBytes) return false;
  frame.length = static_cast<uint8_t>(length);
  return true;
}

}  // namespace

bool parse_log_line(std::string_view line, LogEntry& entry) {
  TextCursor cursor{line};
  entry = LogEntry();
  hal::CanFrame& frame = entry.frame;
  cursor.take_blanks();
  if (!take_time(cursor, frame.time_ns) || !cursor.take_blanks()) return false;
  entry.has_time = true;
  entry.interface = std::string(cursor.take_word());
  if (entry.interface.empty() || !cursor.take_blanks()) return false;
  if (!take_id(cursor, frame.id, frame.extended, frame.error) || !cursor.take('#')) return false;
  if (cursor.take('#')) {
    uint32_t fd_flags = 0;
    if (cursor.take_hex(fd_flags, 1) != 1) return false;
    frame.fd = true;
    frame.flags = static_cast<uint8_t>(fd_flags & 3u);
    if (!take_bytes(cursor, frame, kMaxFdBytes)) return false;
  } else if (cursor.take('R')) {
    if (!take_remote(cursor, frame)) return false;
  } else if (!take_bytes(cursor, frame, kMaxClassicBytes)) {
    return false;
  }
  if (cursor.take('_')) {
    uint32_t code = 0;
    if (frame.fd || frame.length != kMaxClassicBytes || cursor.take_hex(code, 1) != 1 || code < 9) return false;
  }
  cursor.take_blanks();
  if (!cursor.at_end() && !cursor.take('T')) cursor.take('R');
  cursor.take_blanks();
  return cursor.at_end();
}

bool parse_line(std::string_view line, LogEntry& entry) {
  while (!line.empty() && (line.back() == '\r' || line.back() == '\n')) line.remove_suffix(1);
  return parse_log_line(line, entry) || parse_screen_line(line, entry);
}

std::string format_line(const hal::CanFrame& frame, std::string_view interface) {
  static const char kHex[] = "0123456789ABCDEF";
  std::string line = fmt::format("({:010}.{:06}) ", frame.time_ns / 1000000000u, frame.time_ns / 1000u % 1000000u);
  line += interface;
  const uint32_t id = frame.error ? frame.id | kErrorFlag : frame.id;
  line += fmt::format(frame.extended || frame.error ? " {:08X}#" : " {:03X}#", id);
  if (frame.remote) {
    line += 'R';
    if (frame.length > 0 && frame.length <= kMaxClassicBytes) line += kHex[frame.length];
    return line;
  }
  if (frame.fd) {
    line += '#';
    line += kHex[frame.flags & 0xF];
  }
  for (int i = 0; i < frame.length && i < kMaxFdBytes; ++i) {
    line += kHex[frame.data[i] >> 4];
    line += kHex[frame.data[i] & 0xF];
  }
  return line;
}

hal::CanFrame to_frame(const firmware::CanFrame& message, uint64_t time_ns) {
  hal::CanFrame frame;
  frame.id = message.id;
  frame.extended = message.extended;
  frame.fd = message.fd;
  frame.length = message.length;
  std::memcpy(frame.data, message.data, sizeof frame.data);
  frame.time_ns = time_ns;
  return frame;
}

firmware::CanFrame to_message(const hal::CanFrame& frame) {
  firmware::CanFrame message;
  message.id = frame.id;
  message.extended = frame.extended;
  message.fd = frame.fd;
  message.length = frame.length;
  std::memcpy(message.data, frame.data, sizeof message.data);
  return message;
}

}  // namespace can_log
