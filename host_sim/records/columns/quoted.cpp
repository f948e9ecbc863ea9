#include "host_sim/records/columns/quoted.hpp"

namespace host_sim {

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text.substr(0, 40)) result += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
  return result + (text.size() > 40 ? "...\"" : "\"");
}

}  // namespace host_sim
