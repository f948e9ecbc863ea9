#include "hal/rig_file/channel_entry.hpp"

namespace rig_file {

const ChannelEntry* entry_of(const RigModel& model, const std::string& channel) {
  for (const ChannelEntry& entry : model.channels)
    if (entry.name == channel) return &entry;
  return nullptr;
}

ChannelEntry& entry_to_write(RigModel& model, const std::string& channel) {
  for (ChannelEntry& entry : model.channels)
    if (entry.name == channel) return entry;
  model.channels.emplace_back().name = channel;
  return model.channels.back();
}

double stated_delay_s(const RigModel& model, const std::string& channel) {
  const ChannelEntry* const entry = entry_of(model, channel);
  return entry == nullptr ? 0.0 : 1e-6 * entry->delay_us;
}

}  // namespace rig_file
