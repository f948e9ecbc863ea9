#include "host_sim/records/csv/text/row_ends.hpp"

#include <algorithm>

#include "host_sim/records/csv/text/text_lines.hpp"

namespace host_sim {
namespace {

constexpr size_t kLinesLookedAt = 300;
constexpr std::string_view kBlanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  const size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) + 1 - first);
}

// A line without what dresses it.
struct Row {
  std::string_view bare;
  bool semicolon = false, bracket = false;  // at its end; on either side
};

Row undressed(std::string_view line) {
  Row row{trimmed(line), false, false};
  if (!row.bare.empty() && row.bare.front() == '[') row.bare.remove_prefix(1), row.bracket = true;
  const auto ends_on = [&](char c) {
    if (row.bare.empty() || row.bare.back() != c) return false;
    row.bare = trimmed(row.bare.substr(0, row.bare.size() - 1));
    return true;
  };
  row.semicolon = ends_on(';');
  if (ends_on(']')) row.bracket = true, row.semicolon = ends_on(';') || row.semicolon;
  row.bare = trimmed(row.bare);
  return row;
}

bool is_numbers(std::string_view bare) {
  return bare.find_first_of("0123456789") != std::string_view::npos &&
         bare.find_first_not_of("0123456789+-.,;:eE \t") == std::string_view::npos;
}

// Whether semicolons end the rows of numbers, all but the last, and stand within none of them, nor within the names above; or whether
// brackets stand around each row or around all.
bool is_dressed(std::string_view content) {
  size_t rows = 0, ended = 0, brackets = 0;
  std::string_view above;  // the last line that is no row of numbers
  for (size_t i = 0; i < kLinesLookedAt && !content.empty(); ++i) {
    const Row row = undressed(take_line(content));
    if (!is_numbers(row.bare)) {
      if (rows == 0 && !row.bare.empty()) above = row.bare;
      continue;
    }
    if (row.bare.find(';') != std::string_view::npos || above.find(';') != std::string_view::npos) return false;
    ++rows;
    ended += row.semicolon ? 1 : 0;
    brackets += row.bracket ? 1 : 0;
  }
  return rows > 1 && (ended + 1 >= rows || brackets == rows || (brackets > 0 && brackets <= 2));
}

}  // namespace

std::string_view without_row_ends(std::string_view content, std::string& buffer) {
  if (!is_dressed(content)) return content;
  std::string out;
  out.reserve(content.size());
  while (!content.empty()) {
    const std::string_view line = take_line(content);
    const Row row = undressed(line);
    const bool only_dress = row.bare.empty() && (row.bracket || row.semicolon);
    out += is_numbers(row.bare) || only_dress ? row.bare : line;
    out += '\n';
  }
  buffer = std::move(out);
  return buffer;
}

}  // namespace host_sim
