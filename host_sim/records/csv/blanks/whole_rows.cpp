#include "host_sim/records/csv/blanks/whole_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "host_sim/records/columns/quoted.hpp"
#include "host_sim/records/csv/blanks/blank_ends.hpp"
#include "host_sim/records/csv/blanks/fill_blanks.hpp"
#include "host_sim/records/csv/blanks/held_commands.hpp"

namespace host_sim {
namespace {

constexpr size_t kFewRows = 10,
                 kFewOf = 100;  // rows without a time, as a spreadsheet leaves them below its last formula

[[noreturn]] void refuse_blank(const BlankEnds& blank, const std::vector<TableColumn>& columns, const CsvTable& table) {
  const bool between = !blank.gap.empty();
  std::string expected = ", expected a finite number";
  if (const double step_s = between && !table.time_s.empty() ? fastest_step(table.time_s, columns) : 0.0; step_s > 0.0)
    expected += fmt::format("; --resample {:.4g} fills single values that are missing", 1.0 / step_s);
  table.refuse(table.line_of(between ? blank.gap_row : 0),
               "column " + (between ? blank.gap : blank.names) + " is " + quoted(table.blank) + expected);
}

// Each channel from its own values; rows in a long gap go.
void fill_between(const std::vector<TableColumn>& columns, CsvTable& table) {
  Record& record = table.record;
  record.own_step_s = fastest_step(table.time_s, columns);
  const FilledBlanks blanks = fill_blanks(table.time_s, columns);
  table.keep_samples(blanks.keep);
  record.notes.push_back(
      "without a value of " + blanks.names + " in some rows: " + std::to_string(blanks.filled) +
      " values interpolated" +
      (blanks.left_out > 0 ? ", " + std::to_string(blanks.left_out) + " rows in longer gaps left out" : ""));
}

void leave_out_ends(const BlankEnds& blank, CsvTable& table) {
  if (blank.at_start + blank.at_end == 0) return;
  table.keep_samples(blank.first, blank.end);
  if (table.record.left_out_before) *table.record.left_out_before += blank.at_start;
  table.record.notes.push_back("left out: " + std::to_string(blank.at_start) + " rows at the start and " +
                               std::to_string(blank.at_end) + " at the end without a value of " + blank.names);
}

}  // namespace

void leave_out_rest(CsvTable& table) {
  const auto nothing = [](double value) { return std::isnan(value); };
  const std::vector<double>& time_s = table.time_s;
  const std::vector<Channel>& channels = table.record.channels;
  const size_t rows = time_s.size();
  size_t end = rows, with_values = 0;
  while (end > 0 && nothing(time_s[end - 1])) {
    --end;
    with_values += std::any_of(channels.begin(), channels.end(),
                               [&](const Channel& channel) { return !nothing(channel.values[end]); });
  }
  const bool few = with_values <= std::max(kFewRows, rows / kFewOf) && end > 0;
  const auto last = few ? time_s.begin() + static_cast<std::ptrdiff_t>(end) : time_s.end();
  const auto gap = std::find_if(time_s.begin(), last, nothing);
  if (gap != last)
    table.refuse(table.line_of(static_cast<size_t>(gap - time_s.begin())),
                 "its time is \"\", expected a finite number");
  if (end == rows) return;
  table.record.notes.push_back("left out: " + std::to_string(rows - end) + (rows - end == 1 ? " row" : " rows") +
                               " at the end " +
                               (with_values > 0   ? "without a time"
                                : rows - end == 1 ? "that holds nothing of it"
                                                  : "that hold nothing of it"));
  table.keep_samples(0, end);
}

void treat_blanks(bool interpolated, CsvTable& table) {
  Record& record = table.record;
  const bool fills = interpolated && !table.time_s.empty();
  if (fills)
    for (std::string& note : hold_commands(table.time_s, record.channels)) record.notes.push_back(std::move(note));
  std::vector<TableColumn> columns, measured;
  for (Channel& channel : record.channels) {
    columns.push_back({channel.name, &channel.values});
    if (!channel.held) measured.push_back(columns.back());
  }
  const BlankEnds blank = find_blank_ends(columns);
  if ((!blank.gap.empty() && !fills) || blank.first == blank.end) refuse_blank(blank, columns, table);
  leave_out_ends(blank, table);
  if (!blank.gap.empty()) fill_between(measured, table);
}

}  // namespace host_sim
