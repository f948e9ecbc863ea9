// Channel names of data files: quantity, DOF number or "base", unit. "velocity_2_m_s", "angle_1_rad",
// "displacement_base_m".
#pragma once
#include <optional>
#include <string>

#include "firmware/configuration/configuration.hpp"
#include "hal/rig_file/rig_model.hpp"

namespace rig_file {

struct ChannelName {
  firmware::Quantity quantity = firmware::Quantity::kDisplacement;
  int dof = 1;  // from 1, or kBase
  bool rotating = false;
};

// Nothing where the name does not follow the pattern.
std::optional<ChannelName> parse_channel_name(const std::string& name);
std::string format_channel_name(const ChannelName& channel);

// Empty where the rig can use the channel; else what is wrong and what was expected.
std::string channel_name_fault(const std::string& name, const RigModel& model);

}  // namespace rig_file
