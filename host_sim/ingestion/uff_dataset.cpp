#include "host_sim/ingestion/uff_dataset.hpp"

#include <cmath>
#include <cstdlib>

#include "host_sim/records/data_file_error.hpp"

namespace host_sim::uff {
namespace {

constexpr int kRealSingle = 2, kRealDouble = 4;

std::string quoted(std::string_view text) { return "\"" + std::string(trimmed(text)) + "\""; }

// Numbers separated by blanks, or touching where a minus sign stands between them.
void append_numbers(const Lines& lines, std::string_view line, size_t wanted, std::vector<double>& values) {
  std::string text(line);
  for (char& c : text)
    if (c == 'D' || c == 'd') c = 'E';
  const char* at = text.c_str();
  while (values.size() < wanted) {
    while (*at == ' ' || *at == '\t') ++at;
    if (*at == '\0') return;
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    if (end == at || !std::isfinite(value))
      lines.fail("expected numbers, found " + quoted(std::string_view(at).substr(0, 20)));
    values.push_back(value);
    at = end;
  }
  if (!trimmed(at).empty()) lines.fail("more values than the " + std::to_string(wanted) + " announced");
}

void read_header(Lines& lines, Function& function) {
  for (int i = 0; i < 5; ++i) lines.required("an identification line");
  const std::string_view dof = lines.required("the DOF identification (record 6)");
  function.function_type = integer_field(lines, dof, 0, 5, "the function type");
  function.entity = trimmed(dof.size() > 31 ? dof.substr(31, 10) : std::string_view());
  function.node = integer_field(lines, dof, 41, 10, "the response node");
  function.direction = integer_field(lines, dof, 51, 4, "the response direction");
}

size_t read_form(Lines& lines, Function& function) {
  const std::string_view form = lines.required("the data form (record 7)");
  const int type = integer_field(lines, form, 0, 10, "the ordinate data type");
  const int count = integer_field(lines, form, 10, 10, "the number of values");
  const int spacing = integer_field(lines, form, 20, 10, "the abscissa spacing");
  function.start_s = real_field(lines, form, 30, 13, "the abscissa minimum");
  function.step_s = real_field(lines, form, 43, 13, "the abscissa increment");
  if (type != kRealSingle && type != kRealDouble)
    lines.fail("ordinate data type " + std::to_string(type) +
               ", expected 2 or 4 (real): a time response is not complex");
  if (count < 2) lines.fail(std::to_string(count) + " values, expected at least 2");
  if (spacing != 1) lines.fail("uneven abscissa spacing, expected 1 (even)");
  if (!(function.step_s > 0.0)) lines.fail("abscissa increment of 0 or less, expected the sample period in seconds");
  return static_cast<size_t>(count);
}

}  // namespace

bool Lines::next(std::string_view& line) {
  if (rest_.empty()) return false;
  const size_t end = rest_.find('\n');
  line = rest_.substr(0, end);
  rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  ++number_;
  return true;
}

std::string_view Lines::required(const char* what) {
  std::string_view line;
  if (!next(line)) fail(std::string("the file ends, expected ") + what);
  return line;
}

void Lines::fail(const std::string& problem) const { throw DataFileError(file_, number_, problem); }

std::string_view trimmed(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

int integer_field(const Lines& lines, std::string_view line, size_t first, size_t width, const char* name) {
  const std::string field(trimmed(line.size() > first ? line.substr(first, width) : std::string_view()));
  char* end = nullptr;
  const long value = std::strtol(field.c_str(), &end, 10);
  if (*end != '\0' || std::labs(value) > 2000000000)
    lines.fail(std::string("expected ") + name + " in columns " + std::to_string(first + 1) + " to " +
               std::to_string(first + width) + ", found " + quoted(field));
  return static_cast<int>(value);
}

double real_field(const Lines& lines, std::string_view line, size_t first, size_t width, const char* name) {
  std::string field(trimmed(line.size() > first ? line.substr(first, width) : std::string_view()));
  for (char& c : field)
    if (c == 'D' || c == 'd') c = 'E';
  char* end = nullptr;
  const double value = std::strtod(field.c_str(), &end);
  if (*end != '\0' || !std::isfinite(value))
    lines.fail(std::string("expected ") + name + " in columns " + std::to_string(first + 1) + " to " +
               std::to_string(first + width) + ", found " + quoted(field));
  return value;
}

Function read_function(Lines& lines) {
  Function function;
  function.line = lines.number() + 1;
  read_header(lines, function);
  const size_t count = read_form(lines, function);
  lines.required("the abscissa (record 8)");
  const std::string_view ordinate = lines.required("the ordinate (record 9)");
  function.ordinate_type = integer_field(lines, ordinate, 0, 10, "the ordinate's data type");
  function.ordinate_unit = trimmed(ordinate.size() > 46 ? ordinate.substr(46, 20) : std::string_view());
  lines.required("the ordinate denominator (record 10)");
  lines.required("the z axis (record 11)");
  std::string_view line = lines.required("values");
  while (trimmed(line) != "-1") {
    append_numbers(lines, line, count, function.values);
    line = lines.required("-1, the end of the dataset");
  }
  if (function.values.size() != count)
    lines.fail(std::to_string(function.values.size()) + " values, expected the " + std::to_string(count) +
               " that record 7 announces");
  return function;
}

Units read_units(Lines& lines) {
  lines.required("the units code");
  const std::string_view factors = lines.required("the unit factors");
  Units units;
  units.length = real_field(lines, factors, 0, 25, "the length factor");
  units.force = real_field(lines, factors, 25, 25, "the force factor");
  if (!(units.length > 0.0) || !(units.force > 0.0)) lines.fail("a unit factor of 0 or less, expected factors above 0");
  while (trimmed(lines.required("-1, the end of the dataset")) != "-1") {
  }
  return units;
}

}  // namespace host_sim::uff
