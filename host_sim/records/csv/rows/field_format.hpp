// One field of a row of numbers: where it ends, and the number in it.
#pragma once
#include <cmath>
#include <optional>
#include <string>

#include "host_sim/records/csv/text/decimal_number.hpp"

namespace host_sim {

// position: where the field begins, then where it has been read to; end: of the row.
struct FieldFormat {
  char separator = ',';
  bool decimal_comma = false;

  static bool begins_number(char c) { return static_cast<unsigned char>(c - '0') < 10 || c == '-'; }

  bool at_end(const char* position, const char* end) const {
    return position == end || *position == separator || (separator == ' ' && *position == '\t');
  }
  void skip_blanks(const char*& position, const char* end) const;
  void skip(const char*& position, const char* end) const;
  // What stands in it, without blanks around it.
  std::string text(const char* position, const char* end) const;

  // A number with nothing around it, as nearly all fields are. False: it is looked at more closely, from where it begins.
  bool take_plain(const char*& position, const char* end, double& value) const {
    if (decimal_comma || position == end || !begins_number(*position)) return false;
    const auto [stop, error] = read_decimal(position, end, value);
    if (error != std::errc() || !at_end(stop, end) || !std::isfinite(value)) return false;
    position = stop;
    return true;
  }

  // A number that may stand in quotes, behind a plus sign, and have a decimal comma. False: it is none.
  bool take_number(const char*& position, const char* end, double& value) const;

  // A field without a value: nothing, or "NaN", as it stands there.
  std::optional<std::string> take_blank(const char*& position, const char* end) const;
};

}  // namespace host_sim
