#include "hal/linux/board/driver_rails.hpp"

#include "hal/rig_file/signal_plan.hpp"

namespace board {

std::string take_driver_rails(const std::vector<hal::IioChannel>& channels, const DriverRange& range,
                              firmware::CoreConfiguration& core) {
  bool any = false;
  for (const hal::IioChannel& channel : channels) {
    if (channel.rails_told) continue;
    const std::optional<hal::CodeRange> told = range(channel);
    if (!told) continue;
    firmware::ChannelConfiguration& target = core.channels[channel.node][static_cast<int>(channel.quantity)];
    target.lowest_code = told->lowest;
    target.highest_code = told->highest;
    any = true;
    constexpr int32_t kReach = 1 << 23;
    if (told->highest - target.offset_code > kReach || target.offset_code - told->lowest > kReach)
      return "channel of " + channel.element + ": its codes go from " + std::to_string(told->lowest) + " to " +
             std::to_string(told->highest) + ", expected an offset_code at most 2^23 away from both";
  }
  if (any) rig_file::plan_signals(core);
  return "";
}

}  // namespace board
