#include "host_sim/records/csv/rows/row_errors.hpp"

#include <algorithm>

#include "host_sim/records/columns/quoted.hpp"
#include "host_sim/records/csv/layout/lvm_header.hpp"
#include "host_sim/records/csv/text/around_values.hpp"
#include "host_sim/records/csv/text/text_lines.hpp"

namespace host_sim {
namespace {

const char* separator_word(char separator) {
  return separator == ',' ? "commas" : separator == ';' ? "semicolons" : separator == '\t' ? "tabs" : "blanks";
}

// Fields beyond the names, and no point in any of them: "0,001,0,25" is two numbers.
bool holds_decimal_commas(const CsvTable& table, const Row& row) {
  if (table.layout.separator != ',' || row.text.find('.') != std::string_view::npos) return false;
  return split_fields(row.text, ',').size() > table.targets.size();
}

}  // namespace

void refuse_field(const CsvTable& table, const Row& row, const std::string& field, const std::string& name) {
  const CsvLayout& layout = table.layout;
  std::string expected = ", expected a finite number";
  if (layout.decimal_comma && field.find('.') != std::string::npos)
    expected += " with a decimal comma, as in the first rows";
  const auto commas = std::count(field.begin(), field.end(), ',');
  if (!layout.decimal_comma && layout.separator != ',' && commas == 1)
    expected += " with a decimal point, as in the first rows";
  if (layout.separator != ',' && commas > 1)
    expected += std::string(", fields separated by ") + separator_word(layout.separator) + " as the names are";
  if (begins_lvm_segment(table.from(row.text))) refuse_segment(table, row.line);
  if (table.is_header(row.text))
    table.refuse(row.line,
                 "holds the names of the columns again, as where a second recording begins: give each a file of its "
                 "own, or take the line out");
  if (!field.empty() && !begins_like_number(field) && field.find_first_of(",;") == std::string::npos)
    expected += "; left blank, --resample fills it in";
  table.refuse(row.line, "column " + name + " is " + quoted(field) + expected);
}

void refuse_too_large(const CsvTable& table, const Row& row, const std::string& field, const std::string& name) {
  table.refuse(row.line, "column " + name + " is " + quoted(field) +
                             ", which is too large in SI units, expected a measured value: check the unit");
}

void refuse_count(const CsvTable& table, const Row& row, size_t fields) {
  const size_t count = table.targets.size();
  table.refuse(
      row.line,
      (fields == count ? "has more fields, expected " : "has " + std::to_string(fields) + " fields, expected ") +
          std::to_string(count) + " numbers separated by " + separator_word(table.layout.separator) +
          (table.samples == 0 ? ", as many as line " + std::to_string(table.layout.header_line) + " has names" : "") +
          (holds_decimal_commas(table, row)
               ? "; where commas are the decimal points too, save it with semicolons between the fields"
               : ""));
}

void refuse_segment(const CsvTable& table, size_t line) {
  table.refuse(line, "begins a second segment with a header of its own, expected one: save each as a file");
}

}  // namespace host_sim
