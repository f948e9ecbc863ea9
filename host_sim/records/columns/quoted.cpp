#include "host_sim/records/columns/quoted.hpp"

#include <algorithm>

namespace host_sim {

std::string quoted(std::string_view text) {
  constexpr size_t kMost = 40;
  size_t end = std::min(text.size(), kMost);
  while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80)
    --end;  // whole letters
  std::string result = "\"";
  for (const char c : text.substr(0, end)) result += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
  return result + (end < text.size() ? "...\"" : "\"");
}

}  // namespace host_sim
