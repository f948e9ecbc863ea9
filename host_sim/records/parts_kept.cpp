#include "host_sim/records/parts_kept.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>

namespace host_sim {
namespace {

constexpr double kFlicker = 2.5;  // steps from end to end: a count to either side of a value

bool rests(const Record& part) {
  return std::none_of(part.channels.begin(), part.channels.end(), [](const Channel& channel) {
    if (channel.quantity == Quantity::kForce || channel.values.empty()) return false;
    const auto [lowest, highest] = std::minmax_element(channel.values.begin(), channel.values.end());
    return *highest - *lowest > kFlicker * channel.recorded_step;
  });
}

bool has_motion(const Record& part) {
  return std::any_of(part.channels.begin(), part.channels.end(),
                     [](const Channel& channel) { return channel.quantity != Quantity::kForce; });
}

// How many go; where all would, none does.
size_t leave_out(std::vector<Record>& parts, const std::function<bool(const Record&)>& is_useless) {
  const auto useless = static_cast<size_t>(std::count_if(parts.begin(), parts.end(), is_useless));
  if (useless == parts.size()) return 0;
  parts.erase(std::remove_if(parts.begin(), parts.end(), is_useless), parts.end());
  return useless;
}

// Of equal ones the later.
size_t leave_out_shortest(std::vector<Record>& parts, size_t most) {
  const size_t before = parts.size();
  while (parts.size() > most) {
    const auto shortest = std::min_element(parts.rbegin(), parts.rend(),
                                           [](const Record& a, const Record& b) { return a.samples() < b.samples(); });
    parts.erase(std::next(shortest).base());
  }
  return before - parts.size();
}

}  // namespace

std::string leave_out_parts(std::vector<Record>& parts) {
  if (parts.size() < 2) return "";
  std::vector<std::string> said;
  const auto say = [&](size_t count, const std::string& what) {
    if (count > 0) said.push_back(fmt::format("{} {}", count, what));
  };
  say(leave_out(parts, [](const Record& part) { return has_motion(part) && rests(part); }), "at rest");
  say(leave_out(parts, [](const Record& part) { return part.samples() < kFewestOfPart; }),
      fmt::format("of fewer than {} samples", kFewestOfPart));
  say(leave_out_shortest(parts, firmware::kMaxLevels),
      fmt::format("shorter than the {} longest", static_cast<int>(firmware::kMaxLevels)));
  return said.empty() ? "" : fmt::format("left out: {}", fmt::join(said, ", "));
}

}  // namespace host_sim
