#include "host_sim/records/csv/text/clock_time.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

namespace host_sim {
namespace {

bool digit(char c) { return c >= '0' && c <= '9'; }

// Takes up to `most` digits off the front; false where there is none.
bool take_integer(std::string_view& text, size_t most, int& value, size_t& digits) {
  value = 0;
  for (digits = 0; digits < most && !text.empty() && digit(text.front()); ++digits) {
    value = 10 * value + (text.front() - '0');
    text.remove_prefix(1);
  }
  return digits > 0;
}

bool take(std::string_view& text, std::string_view any_of) {
  if (text.empty() || any_of.find(text.front()) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

// Days since 1970-01-01 of the Gregorian calendar: years begin in March, so that the leap day is their last.
int64_t days_since_1970(int year, int month, int day) {
  const int64_t y = month > 2 ? year : year - 1;
  const int64_t month_of_march_year = (month + 9) % 12;
  const int64_t day_of_year = (153 * month_of_march_year + 2) / 5 + day - 1;
  return 365 * y + y / 4 - y / 100 + y / 400 + day_of_year - 719468;
}

struct Date {
  int part[3] = {};
  bool year_first = false, with_points = false;
};

// Takes a date off the front.
bool take_parts(std::string_view& text, Date& date) {
  std::string_view rest = text;
  size_t digits[3] = {};
  for (int i = 0; i < 3; ++i) {
    if (i == 1) date.with_points = !rest.empty() && rest.front() == '.';
    if (i > 0 && !take(rest, "-/.")) return false;
    if (!take_integer(rest, 4, date.part[i], digits[i])) return false;
  }
  date.year_first = digits[0] == 4;
  text = rest;
  return date.year_first || digits[2] == 4;
}

bool take_date(std::string_view& text, DateOrder order, int64_t& days) {
  std::string_view rest = text;
  Date date;
  if (!take_parts(rest, date)) return false;
  const auto& part = date.part;
  if (date.with_points) order = DateOrder::kDayFirst;
  const int least = date.year_first ? part[1] : std::min(part[0], part[1]);
  const int most = date.year_first ? part[2] : std::max(part[0], part[1]);
  if (least < 1 || least > 12 || most < 1 || most > 31) return false;
  days = date.year_first ? days_since_1970(part[0], part[1], part[2]) : days_of({part[0], part[1], part[2]}, order);
  text = rest;
  return true;
}

// "AM", " pm": twelve hours twice a day, each beginning with its twelfth. False where there is no such hour.
bool take_half_of_day(std::string_view& text, int& hour) {
  std::string_view rest = text;
  take(rest, " ");
  const bool morning = take(rest, "aA");
  if ((!morning && !take(rest, "pP")) || !take(rest, "mM")) return true;
  if (hour < 1 || hour > 12) return false;
  hour = hour % 12 + (morning ? 0 : 12);
  text = rest;
  return true;
}

bool take_time_of_day(std::string_view& text, double& time_s) {
  int hour = 0, minute = 0, second = 0;
  size_t digits = 0;
  if (!take_integer(text, 2, hour, digits) || !take(text, ":") || !take_integer(text, 2, minute, digits)) return false;
  if (!take(text, ":") || !take_integer(text, 2, second, digits)) return false;
  std::string fraction = "0.";
  if (take(text, ".,"))
    for (; !text.empty() && digit(text.front()); text.remove_prefix(1)) fraction += text.front();
  if (!take_half_of_day(text, hour) || hour > 23 || minute > 59 || second > 60) return false;
  time_s = 3600.0 * hour + 60.0 * minute + second + std::strtod((fraction + "0").c_str(), nullptr);
  return true;
}

// "Z", "+01:00", "+0100", "-05".
bool take_zone(std::string_view& text) {
  if (text.empty() || take(text, "Zz")) return true;
  if (!take(text, "+-")) return false;
  while (!text.empty() && (digit(text.front()) || text.front() == ':')) text.remove_prefix(1);
  return true;
}

}  // namespace

std::optional<YearLastDate> uncertain_date(std::string_view text) {
  Date date;
  if (!take_parts(text, date) || date.year_first || date.with_points) return std::nullopt;
  return YearLastDate{date.part[0], date.part[1], date.part[2]};
}

int64_t days_of(const YearLastDate& date, DateOrder order) {
  int month = date.second, day = date.first;
  if (month > 12 || (order == DateOrder::kMonthFirst && day <= 12)) std::swap(month, day);  // 03/31/2026
  return days_since_1970(date.year, month, day);
}

std::optional<ClockTime> parse_clock_time(std::string_view text, DateOrder order) {
  ClockTime time;
  if (take_date(text, order, time.day) && !take(text, "Tt _")) return std::nullopt;
  if (!take_time_of_day(text, time.time_s) || !take_zone(text) || !text.empty()) return std::nullopt;
  return time;
}

}  // namespace host_sim
