// Times of day and dates as loggers write them in place of seconds.
#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

namespace host_sim {

struct ClockTime {
  int64_t day = 0;      // days since 1970-01-01; 0 where the text has no date
  double time_s = 0.0;  // since midnight
};

// How dates are read whose year stands last: 03/04/2026.
enum class DateOrder { kDayFirst, kMonthFirst };

// The two numbers before a year that stands last.
struct YearLastDate {
  int first = 0, second = 0, year = 0;
};
// Of a text that begins with one whose order is not certain: with points the day always stands first.
std::optional<YearLastDate> uncertain_date(std::string_view text);
// Since 1970-01-01. A month above 12 is the day.
int64_t days_of(const YearLastDate& date, DateOrder order);

// "2026-03-01T10:11:12.123", with a blank or "_" for the T, with "/" or "." in the date and the year first or last
// ("01.03.2026", "03/01/2026"), with "Z" or a zone behind it; "10:11:12.123" alone; "10:11:12 PM". A comma may be the decimal point.
// Nothing where it is no time of a clock.
std::optional<ClockTime> parse_clock_time(std::string_view text, DateOrder order = DateOrder::kDayFirst);

}  // namespace host_sim
