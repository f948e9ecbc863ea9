#include "host_sim/can_log/asc_line.hpp"

#include <charconv>

#include "host_sim/can_log/text_cursor.hpp"

namespace can_log {
namespace {

std::string_view take_token(TextCursor& cursor) {
  cursor.take_blanks();
  return cursor.take_word();
}

bool number(std::string_view token, int base, uint32_t& value) {
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value, base);
  return error == std::errc() && end == token.data() + token.size();
}

// "12.345678"
bool take_seconds(TextCursor& cursor, uint64_t& time_ns) {
  uint64_t seconds = 0, fraction = 0;
  cursor.take_blanks();
  if (cursor.take_decimal(seconds, 9) == 0 || !cursor.take('.')) return false;
  int digits = cursor.take_decimal(fraction, 9);
  if (digits == 0) return false;
  for (; digits < 9; ++digits) fraction *= 10;
  time_ns = seconds * 1000000000u + fraction;
  return true;
}

bool take_identifier(std::string_view token, int base, hal::CanFrame& frame) {
  frame.extended = !token.empty() && (token.back() == 'x' || token.back() == 'X');
  if (frame.extended) token.remove_suffix(1);
  return number(token, base, frame.id) && frame.id <= (frame.extended ? kExtendedMask : 0x7FFu);
}

bool is_direction(std::string_view token) { return token == "Rx" || token == "Tx" || token == "TxRq"; }

bool take_bytes(TextCursor& cursor, int base, int count, hal::CanFrame& frame) {
  for (int i = 0; i < count; ++i) {
    uint32_t byte = 0;
    if (!number(take_token(cursor), base, byte) || byte > 0xFF) return false;
    frame.data[i] = static_cast<uint8_t>(byte);
  }
  frame.length = static_cast<uint8_t>(count);
  return true;
}

// "1  123  Rx  d 8 11 ...", behind the time.
bool take_classic(TextCursor cursor, int base, LogEntry& entry) {
  entry.interface = std::string(take_token(cursor));
  uint32_t channel = 0, length = 0;
  if (!number(entry.interface, 10, channel) || !take_identifier(take_token(cursor), base, entry.frame)) return false;
  if (!is_direction(take_token(cursor))) return false;
  const std::string_view kind = take_token(cursor);
  entry.frame.remote = kind == "r";
  if (entry.frame.remote) return true;
  return kind == "d" && number(take_token(cursor), base, length) && length <= kMaxClassicBytes &&
         take_bytes(cursor, base, static_cast<int>(length), entry.frame);
}

// "CANFD  1 Rx  123  Name  1 0 9 12 11 22 ...", behind the time: bit rate switch, error state, length code, length.
bool take_fd(TextCursor cursor, int base, LogEntry& entry) {
  if (take_token(cursor) != "CANFD") return false;
  entry.interface = std::string(take_token(cursor));
  if (!is_direction(take_token(cursor)) || !take_identifier(take_token(cursor), base, entry.frame)) return false;
  std::string_view flag = take_token(cursor);
  if (flag != "0" && flag != "1") flag = take_token(cursor);  // behind a name
  const std::string_view state = take_token(cursor), code = take_token(cursor);
  uint32_t length = 0, unused = 0;
  if ((flag != "0" && flag != "1") || (state != "0" && state != "1") || !number(code, 16, unused)) return false;
  if (!number(take_token(cursor), 10, length) || length > kMaxFdBytes) return false;
  entry.frame.fd = true;
  entry.frame.flags = static_cast<uint8_t>((flag == "1" ? 1 : 0) | (state == "1" ? 2 : 0));
  return take_bytes(cursor, base, static_cast<int>(length), entry.frame);
}

}  // namespace

bool AscLog::take_header(std::string_view line) {
  if (line.substr(0, 5) != "base ") return false;
  base_ = line.find("dec") == std::string_view::npos ? 16 : 10;
  relative_ = line.find("relative") != std::string_view::npos;
  return true;
}

bool AscLog::parse(std::string_view line, LogEntry& entry) {
  while (!line.empty() && (line.back() == '\r' || line.back() == '\n')) line.remove_suffix(1);
  entry = LogEntry();
  if (take_header(line)) return false;
  TextCursor cursor{line};
  uint64_t time_ns = 0;
  if (!take_seconds(cursor, time_ns) || !cursor.take_blanks()) return false;
  if (relative_) time_ns += last_ns_;
  last_ns_ = time_ns;
  for (const auto take : {take_classic, take_fd}) {
    entry = LogEntry();
    if (!take(cursor, base_, entry)) continue;
    entry.has_time = true;
    entry.frame.time_ns = time_ns;
    return true;
  }
  return false;
}

bool is_asc_log(std::string_view content) {
  return content.substr(0, 5) == "date " && content.substr(0, 400).find("\nbase ") != std::string_view::npos;
}

}  // namespace can_log
