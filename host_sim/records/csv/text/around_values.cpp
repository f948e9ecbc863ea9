#include "host_sim/records/csv/text/around_values.hpp"

#include <algorithm>
#include <cctype>

#include "host_sim/records/columns/names/column_name.hpp"
#include "host_sim/records/csv/text/text_lines.hpp"

namespace host_sim {

bool says_no_value(std::string_view field) {
  constexpr size_t kLongest = 12;
  if (field.empty()) return true;
  if (field.size() > kLongest) return false;
  std::string low(field);
  std::transform(low.begin(), low.end(), low.begin(), [](unsigned char c) { return std::tolower(c); });
  constexpr std::string_view kWords[] = {
      "nan",       "na",        "n/a",     "#n/a",     "null",   "none",    "-",       "nan(ind)", "-nan", "+nan",
      "-nan(ind)", "nan(snan)", "1.#qnan", "-1.#qnan", "1.#ind", "-1.#ind", "1.#snan", "<na>",     "nil"};
  return std::find(std::begin(kWords), std::end(kWords), low) != std::end(kWords);
}

bool begins_like_number(std::string_view line) {
  const size_t first = line.find_first_not_of(" \t\"'");
  if (first == std::string_view::npos) return false;
  const size_t digit = line.find_first_not_of("+-.", first);
  return digit != std::string_view::npos && line[digit] >= '0' && line[digit] <= '9';
}

std::optional<size_t> text_below(std::string_view lines) {
  constexpr size_t kMost = 50;
  size_t text = 0;
  for (size_t i = 0; !lines.empty(); ++i) {
    const std::string_view line = take_line(lines);
    if (is_blank(line) || is_comment(line)) continue;
    if (i >= kMost || begins_like_number(line)) return std::nullopt;
    ++text;
  }
  return text;
}

}  // namespace host_sim
