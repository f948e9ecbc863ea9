// A position in a line, for hand-written parsing: each function takes what it names, or leaves the position where it
// was.
#pragma once
#include <cstdint>
#include <string_view>

namespace can_log {

constexpr uint32_t kExtendedMask = 0x1FFFFFFF;
constexpr uint32_t kErrorFlag = 0x20000000;
constexpr int kMaxClassicBytes = 8;
constexpr int kMaxFdBytes = 64;

inline int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return -1;
}

struct TextCursor {
  std::string_view text;

  bool at_end() const { return text.empty(); }
  bool take(char c) {
    if (text.empty() || text.front() != c) return false;
    text.remove_prefix(1);
    return true;
  }
  bool take(std::string_view word) {
    if (text.substr(0, word.size()) != word) return false;
    text.remove_prefix(word.size());
    return true;
  }
  bool take_blanks() {
    bool any = false;
    while (take(' ') || take('\t')) any = true;
    return any;
  }
  std::string_view take_word() {
    size_t n = 0;
    while (n < text.size() && text[n] != ' ' && text[n] != '\t') ++n;
    const std::string_view word = text.substr(0, n);
    text.remove_prefix(n);
    return word;
  }
  // Up to `most` hexadecimal digits; returns how many.
  int take_hex(uint32_t& value, int most) {
    int digits = 0;
    value = 0;
    while (digits < most && !text.empty() && hex_digit(text.front()) >= 0) {
      value = value << 4 | static_cast<uint32_t>(hex_digit(text.front()));
      text.remove_prefix(1);
      ++digits;
    }
    return digits;
  }
  // Up to `most` (18 or fewer) decimal digits; returns how many.
  int take_decimal(uint64_t& value, int most) {
    int digits = 0;
    value = 0;
    while (digits < most && !text.empty() && text.front() >= '0' && text.front() <= '9') {
      value = value * 10 + static_cast<uint64_t>(text.front() - '0');
      text.remove_prefix(1);
      ++digits;
    }
    return digits;
  }
};

// Days from 1 January 1970 to a date of the Gregorian calendar, whose years are taken to begin in March.
inline int64_t days_since_1970(int64_t year, int64_t month, int64_t day) {
  if (month <= 2) --year;
  const int64_t era = year / 400, year_of_era = year - 400 * era,
                day_of_year = (153 * (month > 2 ? month - 3 : month + 9) + 2) / 5 + day - 1,
                day_of_era = 365 * year_of_era + year_of_era / 4 - year_of_era / 100 + day_of_year;
  return era * 146097 + day_of_era - 719468;
}

// "2026-11-22 07:00:00" as seconds since 1970, the clock taken as UTC.
inline bool take_calendar(TextCursor& cursor, uint64_t& seconds) {
  TextCursor ahead = cursor;
  uint64_t year = 0, part[5] = {};  // month, day, hour, minute, second
  const char before[5] = {'-', '-', ' ', ':', ':'};
  if (ahead.take_decimal(year, 4) != 4 || year < 1970) return false;
  for (int i = 0; i < 5; ++i)
    if (!ahead.take(before[i]) || ahead.take_decimal(part[i], 2) != 2) return false;
  if (part[0] < 1 || part[0] > 12 || part[1] < 1 || part[1] > 31 || part[2] > 23 || part[3] > 59 || part[4] > 60)
    return false;
  const int64_t days =
      days_since_1970(static_cast<int64_t>(year), static_cast<int64_t>(part[0]), static_cast<int64_t>(part[1]));
  seconds = static_cast<uint64_t>(days) * 86400u + part[2] * 3600u + part[3] * 60u + part[4];
  cursor = ahead;
  return true;
}

// "(seconds.fraction)" or "(2026-11-22 07:00:00.fraction)" (candump -tA), one to nine decimals.
inline bool take_time(TextCursor& cursor, uint64_t& time_ns) {
  TextCursor ahead = cursor;
  uint64_t seconds = 0, fraction = 0;
  if (!ahead.take('(')) return false;
  if (!take_calendar(ahead, seconds) && ahead.take_decimal(seconds, 10) == 0) return false;
  if (!ahead.take('.')) return false;
  int digits = ahead.take_decimal(fraction, 9);
  if (digits == 0 || !ahead.take(')')) return false;
  for (; digits < 9; ++digits) fraction *= 10;
  time_ns = seconds * 1000000000u + fraction;
  cursor = ahead;
  return true;
}

// Three digits: 11 bits; eight: 29 bits or an error frame.
inline bool take_id(TextCursor& cursor, uint32_t& id, bool& extended, bool& error) {
  uint32_t value = 0;
  const int digits = cursor.take_hex(value, 8);
  error = digits == 8 && (value & kErrorFlag) != 0;
  extended = digits == 8 && !error;
  id = value & kExtendedMask;
  return (digits == 3 && value < 0x800) || (digits == 8 && value < 0x40000000);
}

}  // namespace can_log
