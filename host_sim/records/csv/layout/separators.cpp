#include "host_sim/records/csv/layout/separators.hpp"

#include <algorithm>
#include <cstring>

#include "host_sim/records/csv/text/text_lines.hpp"

namespace host_sim {
namespace {

constexpr char kSeparators[] = {'\t', ';', ',', ' '};

}  // namespace

size_t channel_fields(std::string_view line, const MeansChannel& means_channel, char& separator) {
  size_t best = 0;
  for (const char candidate : kSeparators) {
    const std::vector<std::string> fields = split_fields(line, candidate);
    const auto count = static_cast<size_t>(std::count_if(fields.begin(), fields.end(), means_channel));
    if (count > best) {
      best = count;
      separator = candidate;
    }
  }
  return best;
}

bool is_row_of_numbers(std::string_view line) {
  bool digit = false;
  for (const char c : line) {
    if (c == '\0' || std::strchr("0123456789+-.,;:/eE \t\r", c) == nullptr) return false;
    digit = digit || (c >= '0' && c <= '9');
  }
  return digit;
}

std::vector<std::string> split_names(std::string_view names, char separator, size_t fields) {
  std::vector<std::string> plain = split_fields(names, separator), wide;
  if (separator != ' ' || plain.size() == fields) return plain;
  for (size_t at = 0; (at = names.find_first_not_of(" \t", at)) != std::string_view::npos;) {
    const size_t end = std::min({names.find("  ", at), names.find('\t', at), names.size()});
    wide.emplace_back(names.substr(at, end - at));
    at = end;
  }
  return wide.size() == fields ? wide : plain;
}

char likely_separator(std::string_view names, std::string_view rest) {
  std::string_view row;
  while (!rest.empty() && is_blank(row)) row = take_line(rest);
  char best = ',';
  size_t most = 1;
  for (const char candidate : kSeparators) {
    const size_t count = split_fields(names, candidate).size();
    if (count > most && split_fields(row, candidate).size() == count) most = count, best = candidate;
  }
  return best;
}

bool same_table(std::string_view row, std::string_view next) {
  bool single = true;
  for (const char separator : kSeparators) {
    const size_t fields = split_fields(row, separator).size(), below = split_fields(next, separator).size();
    if (fields > 1 && fields == below) return true;
    single = single && fields <= 1 && below <= 1;
  }
  return single;
}

std::optional<char> separator_of_names(std::string_view names, std::string_view row) {
  std::optional<char> best;
  size_t most = 1;
  bool single = true;
  for (const char candidate : kSeparators) {
    const size_t fields = split_fields(row, candidate).size(), count = split_names(names, candidate, fields).size();
    if (count > most && fields == count) most = count, best = candidate;
    single = single && fields <= 1 && (count <= 1 || candidate == ' ');
  }
  return single ? ',' : best;
}

size_t fields_of(std::string_view row, char separator) {
  size_t fields = split_fields(row, separator).size();
  for (const char other : kSeparators)
    if (fields <= 1) fields = split_fields(row, other).size();
  return fields;
}

}  // namespace host_sim
