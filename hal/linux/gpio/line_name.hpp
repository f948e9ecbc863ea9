// How a configuration names a digital line.
#pragma once
#include <cctype>
#include <string>

namespace hal {

struct LineName {
  std::string chip;  // "gpiochip0"; empty: found by name
  unsigned offset = 0;
  std::string name;
};

// "gpiochip0:8" is chip and offset, anything else a line's name.
inline LineName parse_line_name(const std::string& text) {
  LineName result;
  const size_t colon = text.rfind(':');
  const bool digits = colon != std::string::npos && colon + 1 < text.size() && text.size() - colon <= 6 &&
                      text.find_first_not_of("0123456789", colon + 1) == std::string::npos;
  if (digits && text.rfind("gpiochip", 0) == 0) {
    result.chip = text.substr(0, colon);
    result.offset = static_cast<unsigned>(std::stoul(text.substr(colon + 1)));
  } else {
    result.name = text;
  }
  return result;
}

inline std::string line_not_found(const std::string& line) {
  return "GPIO line \"" + line + "\" was not found, expected a name or chip:offset from `gpioinfo`";
}

}  // namespace hal
