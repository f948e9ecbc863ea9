#include "host_sim/records/csv/rows/date_order.hpp"

#include <algorithm>
#include <optional>

#include "host_sim/records/csv/text/text_lines.hpp"

namespace host_sim {
namespace {

constexpr size_t kDateLength = 10;

std::string_view field_of(std::string_view row, size_t column, const FieldFormat& format) {
  const char* position = row.data();
  const char* end = row.data() + row.size();
  for (size_t i = 0; i < column; ++i) {
    format.skip(position, end);
    if (position == end) return {};
    ++position;
  }
  while (position != end && (*position == ' ' || *position == '"')) ++position;
  return {position, static_cast<size_t>(end - position)};
}

}  // namespace

DateOrder date_order_of(const CsvTable& table, const FieldFormat& format) {
  const auto times = std::find_if(table.targets.begin(), table.targets.end(),
                                  [&](const Target& target) { return target.values == &table.time_s; });
  const auto column = static_cast<size_t>(times - table.targets.begin());
  std::optional<YearLastDate> first, last;
  std::string_view before;
  for (std::string_view rest = table.layout.data; !rest.empty();) {
    const std::string_view text = field_of(take_line(rest), column, format).substr(0, kDateLength);
    if (text == before) continue;
    before = text;
    const std::optional<YearLastDate> date = uncertain_date(text);
    if (!date) continue;
    if (date->first > 12) return DateOrder::kDayFirst;
    if (date->second > 12) return DateOrder::kMonthFirst;
    if (!first) first = date;
    last = date;
  }
  if (!first) return DateOrder::kDayFirst;
  const auto days = [&](DateOrder order) { return days_of(*last, order) - days_of(*first, order); };
  const int64_t day_first = days(DateOrder::kDayFirst), month_first = days(DateOrder::kMonthFirst);
  return month_first >= 0 && (day_first < 0 || month_first < day_first) ? DateOrder::kMonthFirst : DateOrder::kDayFirst;
}

}  // namespace host_sim
