#include "host_sim/records/csv/text/text_lines.hpp"

#include <cstring>

namespace host_sim {
namespace {

bool blank(char c) { return c == ' ' || c == '\t'; }

// "-----+-----" or "=====": what is drawn below the names.
bool is_ruled(std::string_view line) {
  return (line.find("---") != std::string_view::npos || line.find("===") != std::string_view::npos) &&
         line.find_first_not_of("-=+|: \t\r,;") == std::string_view::npos;
}

}  // namespace

std::vector<std::string> split_fields(std::string_view line, char separator) {
  std::vector<std::string> fields;
  std::string field;
  bool inside = false, any = false;
  if (separator == ' ')
    while (!line.empty() && blank(line.front())) line.remove_prefix(1);
  for (size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"') {
      inside = !inside;
      any = true;
    } else if (!inside && (separator == ' ' ? blank(c) : c == separator)) {
      if (separator == ' ' && field.empty() && !any) continue;
      fields.push_back(field);
      field.clear();
      any = false;
    } else {
      field += c;
    }
  }
  if (separator != ' ' || !field.empty() || any) fields.push_back(field);
  return fields;
}

std::string_view take_line(std::string_view& rest) {
  const size_t end = rest.find('\n');
  std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t\r") == std::string_view::npos; }

bool is_comment(std::string_view line) {
  const size_t first = line.find_first_not_of(" \t\"");
  if (first == std::string_view::npos) return false;
  if (std::strchr("-=+|", line[first]) != nullptr) return is_ruled(line);
  return line[first] == '#' || line[first] == '%' || line.substr(first, 2) == "//";
}

}  // namespace host_sim
