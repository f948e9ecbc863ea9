#include "host_sim/records/csv/rows/field_format.hpp"

#include <cstring>

#include "host_sim/records/columns/names/column_name.hpp"
#include "host_sim/records/csv/text/around_values.hpp"

namespace host_sim {
namespace {

bool number_with_comma(const char*& position, const char* end, double& value) {
  char digits[64];
  size_t length = 0;
  const char* at = position;
  for (; at != end && length < sizeof digits && std::strchr("+-0123456789eE,", *at) != nullptr; ++at)
    digits[length++] = *at == ',' ? '.' : *at;
  const auto [stop, error] = read_decimal(digits, digits + length, value);
  position += stop - digits;
  return error == std::errc();
}

bool number_with_point(const char*& position, const char* end, double& value) {
  const auto [stop, error] = read_decimal(position, end, value);
  position = stop;
  return error == std::errc();
}

}  // namespace

void FieldFormat::skip_blanks(const char*& position, const char* end) const {
  while (position != end && (*position == ' ' || (*position == '\t' && separator != '\t'))) ++position;
}

void FieldFormat::skip(const char*& position, const char* end) const {
  skip_blanks(position, end);
  for (bool inside = false; position != end && (inside || !at_end(position, end)); ++position)
    if (*position == '"') inside = !inside;
}

std::string FieldFormat::text(const char* position, const char* end) const {
  const char* stop = position;
  skip(stop, end);
  return trimmed_text(std::string(position, stop));
}

bool FieldFormat::take_number(const char*& position, const char* end, double& value) const {
  const bool in_quotes = position != end && *position == '"';
  if (in_quotes) ++position;
  if (position != end && *position == '+') ++position;
  bool good = decimal_comma ? number_with_comma(position, end, value) : number_with_point(position, end, value);
  if (in_quotes) {
    good = good && position != end && *position == '"';
    if (good) ++position;
  }
  if (separator != ' ') skip_blanks(position, end);
  return good && at_end(position, end) && std::isfinite(value);
}

std::optional<std::string> FieldFormat::take_blank(const char*& position, const char* end) const {
  const char c = position == end ? ' ' : *position;
  const char* const next = position == end ? end : position + 1;
  if ((c == '-' || c == '+') && next != end && ((*next >= '0' && *next <= '9') || *next == '.')) return std::nullopt;
  if ((c >= '0' && c <= '9' && !(c == '1' && end - position > 2 && position[2] == '#')) || c == '.')
    return std::nullopt;
  std::string field = text(position, end);
  if (field.size() > 1 && field.front() == '"' && field.back() == '"') field = field.substr(1, field.size() - 2);
  if (!says_no_value(field)) return std::nullopt;
  skip(position, end);
  return field;
}

}  // namespace host_sim
