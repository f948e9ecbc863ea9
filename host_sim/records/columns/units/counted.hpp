// So many of a unit.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace host_sim {

// "100 mV": a count and what stands behind it; nothing where there is none, or nought.
struct Counted {
  double count = 0.0;
  std::string_view said, rest;  // the count as it stands there, and what is behind it
};
std::optional<Counted> take_count(const std::string& text);

}  // namespace host_sim
