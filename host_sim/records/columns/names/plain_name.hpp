// Heads of recordings of one part: a quantity and its unit, without a DOF's number. "Position (m)", "angle_deg".
#pragma once
#include <optional>
#include <string>

#include "hal/rig_file/channel_name.hpp"

namespace host_sim {

struct PlainName {
  rig_file::ChannelName channel;  // of DOF 1; whether it rotates tells the unit, or without one the word
  std::string unit;               // as it stands in the head: "deg"; may be empty
};

// name, unit: the parts of the head, the unit perhaps of a row of units. Nothing where the name is no quantity's word
// (position, displacement, deflection, elongation, travel, stroke, angle, velocity, speed, acceleration, force, load,
// torque, some with "angular" before them, and pos, disp, vel, angvel, acc, accel), or where the unit measures something else.
std::optional<PlainName> parse_plain_name(const std::string& name, const std::string& unit);

}  // namespace host_sim
