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

// "2026-03-01T10:11:12.123", with a blank or "_" for the T, with "/" or "." in the date and the year first or last
// ("01.03.2026", "03/01/2026": only differences of days matter, and a record that goes on past midnight of an ambiguous
// date is told as uneven steps), with "Z" or a zone behind it; "10:11:12.123" alone; "10:11:12 PM". A comma may be the decimal point.
// Nothing where it is no time of a clock.
std::optional<ClockTime> parse_clock_time(std::string_view text);

}  // namespace host_sim
