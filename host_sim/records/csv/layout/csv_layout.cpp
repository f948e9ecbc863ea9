#include "host_sim/records/csv/layout/csv_layout.hpp"

#include "host_sim/records/csv/layout/header_line.hpp"
#include "host_sim/records/csv/layout/units_row.hpp"
#include "host_sim/records/csv/text/text_lines.hpp"

namespace host_sim {
namespace {

void skip_blank_and_comment_lines(CsvLayout& layout) {
  for (std::string_view rest = layout.data; !rest.empty();) {
    const std::string_view line = take_line(rest);
    if (!is_comment(line) && !(is_blank(line) && !is_blank(rest))) return;
    if (is_blank(line) && rest.find_first_not_of(" \t\r\n") == std::string_view::npos) return;
    layout.data = rest;
    ++layout.data_line;
  }
}

bool commas_are_points(const CsvLayout& layout) {
  if (layout.separator == ',') return false;
  constexpr int kRowsLookedAt = 100;
  std::string_view rest = layout.data;
  bool comma = false;
  for (int i = 0; i < kRowsLookedAt && !rest.empty(); ++i) {
    const std::string_view line = take_line(rest);
    if (is_comment(line)) continue;
    for (const std::string& field : split_fields(line, layout.separator)) {
      if (!has_digit_first(field)) continue;
      if (field.find_first_of(":") != std::string::npos) continue;  // a clock
      if (field.find('.') != std::string::npos) return false;
      comma = comma || field.find(',') != std::string::npos;
    }
  }
  return comma;
}

// The first row of numbers; empty where it does not come soon.
std::string_view first_row(std::string_view content) {
  constexpr int kLines = 10;
  for (int i = 0; i < kLines && !content.empty(); ++i)
    if (const std::string_view line = take_line(content); is_row_of_numbers(line)) return line;
  return {};
}

// fields: of the first row of numbers.
void note_what_is_passed_over(const Header& header, size_t fields, CsvLayout& layout) {
  if (header.surplus)
    layout.notes.push_back("line " + std::to_string(header.line) + " names " + std::to_string(layout.columns.size()) +
                           " columns, the rows have " + std::to_string(fields) + ": named from the left");
  if (header.passed_over > 0)
    layout.notes.push_back("passed over: " + std::to_string(header.passed_over) + " line" +
                           (header.passed_over == 1 ? "" : "s") + " before the " +
                           (header.unnamed ? "numbers" : "names") + " of line " + std::to_string(header.line));
}

}  // namespace

CsvLayout find_layout(std::string_view content, const MeansChannel& means_channel) {
  const LvmHeader lvm = lvm_header_of(content);
  const Header header = lvm.lines > 0 ? header_below(lvm) : find_header(content, means_channel);
  CsvLayout layout;
  layout.separator = header.separator;
  layout.header_line = header.line;
  layout.data = header.rest;
  layout.data_line = header.line + (header.unnamed ? 0 : 1);
  layout.unnamed = header.unnamed;
  layout.unfit = header.unfit;
  const size_t fields = split_fields(first_row(header.rest), header.separator).size();
  for (const std::string& field : split_names(header.text, header.separator, fields))
    layout.columns.push_back({header.unnamed ? std::to_string(layout.columns.size() + 1) : field, ""});
  note_what_is_passed_over(header, fields, layout);
  if (!lvm.has_times) layout.step_s = lvm.step_s;
  skip_blank_and_comment_lines(layout);
  if (!layout.unnamed && take_units(layout))
    skip_blank_and_comment_lines(layout);
  else
    find_units_above(content, layout);
  layout.decimal_comma = commas_are_points(layout);
  return layout;
}

}  // namespace host_sim
