#include "host_sim/records/parts_kept.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "firmware/configuration/configuration.hpp"

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

bool moves_at_all(const Record& part) {
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

// Of equal ones the earlier.
size_t leave_out_shortest(std::vector<Record>& parts, size_t most) {
  if (parts.size() <= most) return 0;
  std::vector<size_t> lengths;
  for (const Record& part : parts) lengths.push_back(part.samples());
  std::sort(lengths.rbegin(), lengths.rend());
  const size_t least = lengths[most - 1], gone = parts.size() - most;
  size_t alike =
      static_cast<size_t>(std::count(lengths.begin(), lengths.begin() + static_cast<std::ptrdiff_t>(most), least));
  parts.erase(std::remove_if(parts.begin(), parts.end(),
                             [&](const Record& part) {
                               if (part.samples() != least) return part.samples() < least;
                               return alike == 0 || alike-- == 0;
                             }),
              parts.end());
  return gone;
}

}  // namespace

std::string leave_out_parts(std::vector<Record>& parts) {
  if (parts.size() < 2) return "";
  std::vector<std::string> said;
  const auto say = [&](size_t count, const std::string& what) {
    if (count > 0) said.push_back(fmt::format("{} {}", count, what));
  };
  say(leave_out(parts, [](const Record& part) { return moves_at_all(part) && rests(part); }), "at rest");
  say(leave_out(parts, [](const Record& part) { return part.samples() < kFewestOfPart; }),
      fmt::format("of fewer than {} samples", kFewestOfPart));
  say(leave_out_shortest(parts, firmware::kMaxLevels),
      fmt::format("shorter than the {} longest", static_cast<int>(firmware::kMaxLevels)));
  return said.empty() ? "" : fmt::format("left out: {}", fmt::join(said, ", "));
}

}  // namespace host_sim
