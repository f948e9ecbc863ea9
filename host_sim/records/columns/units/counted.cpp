#include "host_sim/records/columns/units/counted.hpp"

#include <charconv>
#include <cmath>

namespace host_sim {

std::optional<Counted> take_count(const std::string& text) {
  const size_t first = text.find_first_not_of(' ');
  if (first == std::string::npos) return std::nullopt;
  double count = 0.0;
  const auto [end, error] = std::from_chars(text.data() + first, text.data() + text.size(), count);
  if (error != std::errc() || !std::isfinite(count) || count == 0.0) return std::nullopt;
  const auto length = static_cast<size_t>(end - text.data());
  return Counted{count, std::string_view(text).substr(first, length - first), std::string_view(text).substr(length)};
}

}  // namespace host_sim
