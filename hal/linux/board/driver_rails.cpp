#include "hal/linux/board/driver_rails.hpp"

namespace board {

std::string take_driver_rails(const std::vector<hal::IioChannel>& channels, const DriverRange& range,
                              firmware::CoreConfiguration& core, const rig_file::SignalRanges& told) {
  bool any = false;
  for (const hal::IioChannel& channel : channels) {
    if (channel.rails_told) continue;
    const std::optional<hal::CodeRange> rails = range(channel);
    if (!rails) continue;
    firmware::ChannelConfiguration& target = core.channels[channel.node][static_cast<int>(channel.quantity)];
    target.lowest_code = rails->lowest;
    target.highest_code = rails->highest;
    any = true;
    constexpr int32_t kReach = 1 << 23;
    if (rails->highest - target.offset_code > kReach || target.offset_code - rails->lowest > kReach)
      return "channel of " + channel.element + ": its codes go from " + std::to_string(rails->lowest) + " to " +
             std::to_string(rails->highest) + ", expected an offset_code at most 2^23 away from both";
  }
  if (any) rig_file::plan_signals(core, told);
  return "";
}

std::string wide_words(const std::vector<hal::IioChannel>& channels, const DriverRange& range) {
  std::string text;
  for (const hal::IioChannel& channel : channels) {
    const std::optional<hal::CodeRange> rails = range(channel);
    if (!rails || rails->dropped_bits == 0) continue;
    text += channel.element + " has " + std::to_string(24 + rails->dropped_bits) +
            " bits, a code is their upper 24: its unit_per_code is of 2^" + std::to_string(rails->dropped_bits) +
            " of the converter's own steps\n";
  }
  return text;
}

}  // namespace board
