// What a rig file says of one channel.
#pragma once
#include <string>

#include "hal/rig_file/rig_model.hpp"

namespace rig_file {

// nullptr: nothing.
const ChannelEntry* entry_of(const RigModel& model, const std::string& channel);
// To add to what it says; an entry that says nothing yet where there is none.
ChannelEntry& entry_to_write(RigModel& model, const std::string& channel);
// How late it is against the others, s; 0 where the file says nothing.
double stated_delay_s(const RigModel& model, const std::string& channel);

}  // namespace rig_file
