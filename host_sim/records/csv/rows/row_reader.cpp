#include "host_sim/records/csv/rows/row_reader.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "host_sim/records/csv/rows/date_order.hpp"
#include "host_sim/records/csv/rows/row_errors.hpp"

namespace host_sim {

void RowReader::read(const Row& row) {
  const char* position = row.text.data();
  const char* end = row.text.data() + row.text.size();
  if (format_.separator == ' ')
    while (end != position && (end[-1] == ' ' || end[-1] == '\t')) --end;
  const size_t count = table_.targets.size();
  for (size_t column = 0; column < count; ++column) {
    const Target& target = table_.targets[column];
    if (target.values == nullptr)
      format_.skip(position, end);
    else
      target.values->push_back(value_of(position, end, target, row));
    const bool last = column + 1 == count;
    if (position == end && column + 1 >= table_.needed) return;                    // what is left out is ignored anyway
    if (last && end - position == 1 && format_.at_end(position, end)) ++position;  // a separator ends the line
    if (last && count > table_.needed) return;  // what has no name is ignored as the columns before it are
    if (last != (position == end)) refuse_count(table_, row, column + 1);
    if (!last) ++position;
  }
}

// The value in SI at the position, which moves to the separator behind it or to the end.
double RowReader::value_of(const char*& position, const char* end, const Target& target, const Row& row) {
  double value = 0.0;
  const char* const start = position;
  const auto in_si = [&] {
    const double si = value * target.factor;
    if (!std::isfinite(si)) refuse_too_large(table_, row, format_.text(start, end), target.name);
    return si;
  };
  if (format_.take_plain(position, end, value)) return in_si();
  const bool is_time = target.values == &table_.time_s;
  if (is_time && take_clock(position, end, value)) return value;
  format_.skip_blanks(position, end);
  if (auto blank = format_.take_blank(position, end)) {
    table_.blank = std::move(*blank);
    table_.lacks_times = table_.lacks_times || is_time;
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (!format_.take_number(position, end, value)) refuse_field(table_, row, format_.text(start, end), target.name);
  return in_si();
}

// A time of day, perhaps with a date, as seconds since the first row's. Past midnight without a date it goes on.
bool RowReader::take_clock(const char*& position, const char* end, double& value) {
  const char* stop = position;
  format_.skip(stop, end);
  if (std::find(position, stop, ':') == stop) return false;
  std::string text = format_.text(position, end);
  text.erase(std::remove(text.begin(), text.end(), '"'), text.end());
  if (!date_order_) date_order_ = date_order_of(table_, format_);
  const std::optional<ClockTime> clock = parse_clock_time(text, *date_order_);
  if (!clock) return false;
  if (table_.samples == 0) first_clock_ = *clock;
  value = 86400.0 * static_cast<double>(clock->day - first_clock_.day) + (clock->time_s - first_clock_.time_s);
  const std::vector<double>& time_s = table_.time_s;
  while (clock->day == 0 && !time_s.empty() && value < time_s.back() - 43200.0) value += 86400.0;
  position = stop;
  return true;
}

}  // namespace host_sim
