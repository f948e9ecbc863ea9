#include "host_sim/ingestion/uff/uff_dataset.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "host_sim/records/files/data_file_error.hpp"

namespace host_sim::uff {
namespace {

constexpr int kRealSingle = 2, kRealDouble = 4;
constexpr int kTimeResponse = 1;  // 0, general or unknown, is taken as one

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

// Behind record 6: what is left of a function that is no time response.
void skip_rest(Lines& lines, const BinaryForm* binary) {
  if (binary != nullptr) {
    for (int i = 7; i <= 11; ++i) lines.required("the header of a binary dataset");
    lines.take_bytes(binary->bytes);
  }
  while (trimmed(lines.required("-1, the end of the dataset")) != "-1") {
  }
}

size_t read_form(Lines& lines, Function& function, int& type) {
  const std::string_view form = lines.required("the data form (record 7)");
  type = integer_field(lines, form, 0, 10, "the ordinate data type");
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

// IEEE 754 numbers of 4 or 8 bytes in either byte order.
void append_binary(const Lines& lines, std::string_view bytes, size_t width, bool big_endian,
                   std::vector<double>& values) {
  for (size_t at = 0; at + width <= bytes.size(); at += width) {
    uint64_t bits = 0;
    for (size_t i = 0; i < width; ++i) {
      const size_t place = big_endian ? width - 1 - i : i;
      bits |= static_cast<uint64_t>(static_cast<uint8_t>(bytes[at + i])) << (8 * place);
    }
    double value = 0.0;
    if (width == 8) {
      std::memcpy(&value, &bits, sizeof value);
    } else {
      const auto half = static_cast<uint32_t>(bits);
      float single = 0.0f;
      std::memcpy(&single, &half, sizeof single);
      value = static_cast<double>(single);
    }
    if (!std::isfinite(value))
      lines.fail("value " + std::to_string(values.size() + 1) + " is not a finite number, expected measured values");
    values.push_back(value);
  }
}

void read_binary_values(Lines& lines, const BinaryForm& binary, int type, size_t count, std::vector<double>& values) {
  const size_t width = type == kRealDouble ? 8 : 4;
  if (binary.bytes != count * width)
    lines.fail(std::to_string(binary.bytes) + " bytes of values, expected the " + std::to_string(count * width) +
               " that record 7 announces");
  append_binary(lines, lines.take_bytes(binary.bytes), width, binary.big_endian, values);
  std::string_view line = lines.required("-1, the end of the dataset");
  while (trimmed(line).empty()) line = lines.required("-1, the end of the dataset");
  if (trimmed(line) != "-1") lines.fail("expected -1, the end of the dataset, behind its binary values");
}

}  // namespace

BinaryForm read_binary_form(const Lines& lines, std::string_view line) {
  constexpr int kLittleEndian = 1, kBigEndian = 2, kIeee754 = 2;
  const int order = integer_field(lines, line, 7, 6, "the byte order"),
            format = integer_field(lines, line, 13, 6, "the floating point format"),
            ascii_lines = integer_field(lines, line, 19, 12, "the number of ASCII lines"),
            bytes = integer_field(lines, line, 31, 12, "the number of bytes");
  if (order != kLittleEndian && order != kBigEndian)
    lines.fail("byte order " + std::to_string(order) + ", expected 1 (little endian) or 2 (big endian)");
  if (format != kIeee754) lines.fail("floating point format " + std::to_string(format) + ", expected 2 (IEEE 754)");
  if (ascii_lines != 11) lines.fail(std::to_string(ascii_lines) + " ASCII lines, expected 11");
  if (bytes <= 0) lines.fail("no bytes of values, expected their number in columns 32 to 43");
  return {order == kBigEndian, static_cast<size_t>(bytes)};
}

std::string_view Lines::take_bytes(size_t count) {
  if (rest_.size() < count)
    fail("the file ends after " + std::to_string(rest_.size()) + " of " + std::to_string(count) + " bytes of values");
  const std::string_view bytes = rest_.substr(0, count);
  rest_.remove_prefix(count);
  return bytes;
}

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

Function read_function(Lines& lines, const BinaryForm* binary) {
  Function function;
  function.line = lines.number() + 1;
  read_header(lines, function);
  if (function.function_type > kTimeResponse) {
    skip_rest(lines, binary);
    return function;
  }
  int type = 0;
  const size_t count = read_form(lines, function, type);
  lines.required("the abscissa (record 8)");
  const std::string_view ordinate = lines.required("the ordinate (record 9)");
  function.ordinate_type = integer_field(lines, ordinate, 0, 10, "the ordinate's data type");
  function.ordinate_unit = trimmed(ordinate.size() > 46 ? ordinate.substr(46, 20) : std::string_view());
  lines.required("the ordinate denominator (record 10)");
  lines.required("the z axis (record 11)");
  if (binary != nullptr) {
    read_binary_values(lines, *binary, type, count, function.values);
    return function;
  }
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
