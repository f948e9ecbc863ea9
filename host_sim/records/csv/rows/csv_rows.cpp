#include "host_sim/records/csv/rows/csv_rows.hpp"

#include <optional>

#include "host_sim/records/columns/names/column_name.hpp"
#include "host_sim/records/csv/layout/lvm_header.hpp"
#include "host_sim/records/csv/rows/last_row.hpp"
#include "host_sim/records/csv/rows/row_errors.hpp"
#include "host_sim/records/csv/rows/row_reader.hpp"
#include "host_sim/records/csv/text/around_values.hpp"
#include "host_sim/records/csv/text/text_lines.hpp"

namespace host_sim {
namespace {

// Whether nothing but text follows, which is said.
bool ends_before(std::string_view lines, CsvTable& table) {
  const std::optional<size_t> text = text_below(lines);
  if (text && *text > 0)
    table.record.notes.push_back("left out: " + std::to_string(*text) + (*text == 1 ? " line" : " lines") +
                                 " of text below the last row of numbers");
  return text.has_value();
}

// Of a table whose rows begin with numbers. The names again and a row without a time are none of it.
bool ends_with_text(std::string_view row, CsvTable& table) {
  std::string_view data = table.layout.data;
  if (begins_lvm_segment(table.from(row)) || !begins_like_number(take_line(data)) || table.is_header(row) ||
      says_no_value(trimmed_text(split_fields(row, table.layout.separator).front())))
    return false;
  return ends_before(table.from(row), table);
}

}  // namespace

void read_rows(CsvTable& table) {
  RowReader reader(table);
  std::string_view rest = table.layout.data, before;
  for (size_t line = table.layout.data_line; !rest.empty(); ++line) {
    const std::string_view row = take_line(rest);
    const bool numbers = !row.empty() && FieldFormat::begins_number(row.front());
    if (!numbers && is_comment(row)) {
      table.comments.push_back(table.samples);
    } else if (!numbers && is_blank(row)) {
      if (begins_lvm_segment(rest)) refuse_segment(table, line);
      if (!ends_before(rest, table))
        table.refuse(line, "is blank, expected " + std::to_string(table.targets.size()) + " numbers");
      break;
    } else if (table.samples > 0 && rest.empty() && breaks_off(row, table, reader.format())) {
      table.record.notes.push_back("left out: the last line, which breaks off in the middle");
    } else if (!numbers && table.samples > 0 && !begins_like_number(row) && ends_with_text(row, table)) {
      break;
    } else {
      if (table.samples > 0 && row == before) table.repeats.push_back(table.samples);
      before = row;
      reader.read({line, row});
      ++table.samples;
    }
  }
}

}  // namespace host_sim
