#include "host_sim/records/columns/reading_options.hpp"

#include <stdexcept>

namespace host_sim {

std::pair<std::string, std::string> parse_choice(const std::string& text) {
  const size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
    throw std::invalid_argument("\"" + text +
                                "\", expected a channel, \"=\" and a text, as in acceleration_1=\"Chan 3\"");
  return {text.substr(0, equals), text.substr(equals + 1)};
}

}  // namespace host_sim
