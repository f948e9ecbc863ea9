#include "hal/rig_file/channel_entry.hpp"

namespace rig_file {

const ChannelEntry* entry_of(const RigModel& model, const std::string& channel) {
  for (const ChannelEntry& entry : model.channels)
    if (entry.name == channel) return &entry;
  return nullptr;
}

double stated_delay_s(const RigModel& model, const std::string& channel) {
  const ChannelEntry* const entry = entry_of(model, channel);
  return entry == nullptr ? 0.0 : 1e-6 * entry->delay_us;
}

double stated_coupling_Hz(const RigModel& model, const std::string& channel) {
  const ChannelEntry* const entry = entry_of(model, channel);
  return entry == nullptr ? 0.0 : entry->ac_coupling_Hz;
}

}  // namespace rig_file
