#include "host_sim/records/csv/layout/units_row.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

#include "host_sim/records/columns/names/column_name.hpp"
#include "host_sim/records/columns/units/units.hpp"
#include "host_sim/records/csv/text/text_lines.hpp"

namespace host_sim {
namespace {

// A row's title that says that units follow.
bool says_units(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text.find("unit") != std::string::npos;
}

// The columns' units, where the fields from `first` on are units or blank, and no number. Behind a title that says so a word that is no
// known unit is one all the same: whose column it is is told, and the others keep theirs.
bool read_units(const std::vector<std::string>& fields, size_t first, CsvLayout& layout) {
  bool any = false;
  const bool titled = first > 0 && !fields.empty() && says_units(fields[0]);
  for (size_t i = first; i < fields.size(); ++i) {
    const std::string text = trimmed_text(fields[i]);
    if (text.empty() || text == "-" || text == "Unit" || text == "Units") continue;  // a row's title is no unit
    if (has_digit_first(text) || (first > 0 && !titled && !find_unit(text))) return false;
    any = any || find_unit(text).has_value();
  }
  if (!any || fields.size() > layout.columns.size() + 1) return false;
  for (size_t i = first; i < std::min(fields.size(), layout.columns.size()); ++i) {
    const HeadParts parts = split_head(fields[i]);
    layout.columns[i].unit = parts.unit.empty() ? parts.name : parts.unit;  // "(mm)" or "mm"
  }
  return true;
}

}  // namespace

bool has_digit_first(const std::string& field) {
  const size_t first = field.find_first_not_of(" +-.,");
  return first != std::string::npos && field[first] >= '0' && field[first] <= '9' && field != "1/min";
}

bool take_units(CsvLayout& layout) {
  std::string_view rest = layout.data;
  if (!read_units(split_fields(take_line(rest), layout.separator), 0, layout)) return false;
  layout.data = rest;
  ++layout.data_line;
  return true;
}

void find_units_above(std::string_view content, CsvLayout& layout) {
  for (size_t number = 1; number < layout.header_line; ++number)
    if (read_units(split_fields(take_line(content), layout.separator), 1, layout)) return;
}

}  // namespace host_sim
