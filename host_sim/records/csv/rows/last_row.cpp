#include "host_sim/records/csv/rows/last_row.hpp"

#include <algorithm>
#include <cctype>
#include <limits>
#include <optional>
#include <string>

#include "host_sim/records/csv/text/around_values.hpp"

namespace host_sim {
namespace {

constexpr size_t kMostRows = 200, kFewestRows = 20;  // that tell how long a column's numbers are

bool is_digit(char c) { return c >= '0' && c <= '9'; }

size_t count_fields(std::string_view row, const FieldFormat& format) {
  const char* position = row.data();
  const char* end = row.data() + row.size();
  size_t fields = 1;
  for (format.skip(position, end); position != end; format.skip(++position, end)) ++fields;
  return fields;
}

// What stands in the last column, with its quotes, where nothing is behind it.
std::optional<std::string> last_field(std::string_view row, const CsvTable& table, const FieldFormat& format) {
  const char* position = row.data();
  const char* end = row.data() + row.size();
  for (size_t column = 1; column < table.targets.size(); ++column) {
    format.skip(position, end);
    if (position == end) return std::nullopt;
    ++position;
  }
  format.skip_blanks(position, end);
  const char* stop = position;
  format.skip(stop, end);
  if (stop != end) return std::nullopt;
  while (stop != position && (stop[-1] == ' ' || stop[-1] == '\t')) --stop;
  return std::string(position, stop);
}

// A word for no value, or what is no number at all, is not cut: it speaks for itself.
bool ends_as_number(const std::string& field) {
  const bool in_quotes = !field.empty() && field.front() == '"';
  if (in_quotes && (field.size() < 2 || field.back() != '"')) return false;
  const std::string text = in_quotes ? field.substr(1, field.size() - 2) : field;
  if (text == "-" || text == "+" || text == ".") return false;
  if (!begins_like_number(text)) return true;
  const char last = text.back();
  if (last == '.' || last == ',') return is_digit(text[text.size() - 2]);
  return std::string_view("eEdD+-").find(last) == std::string_view::npos;
}

// Characters of a number without a sign and quotes, and digits of its exponent where it has one.
struct Written {
  size_t length = 0, exponent = 0;
};

Written written(const std::string& field) {
  Written result;
  result.length = static_cast<size_t>(
      std::count_if(field.begin(), field.end(), [](char c) { return c != '"' && c != '+' && c != '-'; }));
  const size_t letter = field.find_last_of("eE");
  if (letter == std::string::npos) return result;
  result.exponent =
      static_cast<size_t>(std::count_if(field.begin() + static_cast<std::ptrdiff_t>(letter), field.end(), is_digit));
  return result;
}

// The line before the one that begins there, within the data; empty at their start.
std::string_view line_before(const char* begin, const CsvTable& table) {
  const char* const first = table.layout.data.data();
  if (begin <= first) return {};
  std::string_view lines(first, static_cast<size_t>(begin - 1 - first));
  return lines.substr(lines.rfind('\n') + 1);  // npos + 1 is 0
}

// Whether the rows before all have a longer number there, or all those with an exponent a longer exponent.
bool is_shorter_than_all(const std::string& field, std::string_view row, const CsvTable& table,
                         const FieldFormat& format) {
  constexpr size_t kNone = std::numeric_limits<size_t>::max();
  Written least{kNone, kNone};
  size_t rows = 0, exponents = 0;
  for (std::string_view line = line_before(row.data(), table); !line.empty() && rows < kMostRows;
       line = line_before(line.data(), table)) {
    if (line.back() == '\r') line.remove_suffix(1);
    const std::optional<std::string> other = last_field(line, table, format);
    if (!other || !begins_like_number(*other)) continue;
    const Written one = written(*other);
    least.length = std::min(least.length, one.length);
    if (one.exponent > 0) least.exponent = std::min(least.exponent, one.exponent), ++exponents;
    ++rows;
  }
  const Written own = written(field);
  return (rows >= kFewestRows && own.length < least.length) ||
         (exponents >= kFewestRows && own.exponent > 0 && own.exponent < least.exponent);
}

}  // namespace

bool breaks_off(std::string_view row, const CsvTable& table, const FieldFormat& format) {
  if (row.data() + row.size() != table.content.data() + table.content.size()) return false;
  if (count_fields(row, format) < table.targets.size()) return true;
  const std::optional<std::string> field = last_field(row, table, format);
  if (!field || field->empty() || table.targets.back().values == nullptr) return false;
  return !ends_as_number(*field) || (begins_like_number(*field) && is_shorter_than_all(*field, row, table, format));
}

}  // namespace host_sim
