// The parts of a column's head: "Displacement 1 (mm)" is the displacement of DOF 1 in mm.
#pragma once
#include <optional>
#include <string>

#include "hal/rig_file/channel_name.hpp"

namespace host_sim {

std::string trimmed_text(const std::string& text);

struct HeadParts {
  std::string name;  // without the brackets and blanks at its ends
  std::string unit;  // what stood in brackets at the end ("mm"), in brackets before the end, or behind a slash
};
HeadParts split_head(const std::string& head);

// "displacement_1", "Displacement 1", "displacement_1_mm": quantity and DOF, and the unit's suffix, which may be empty
// or no unit at all. Nothing where the name does not begin with a quantity and a DOF.
struct NamedChannel {
  rig_file::ChannelName channel;
  std::string suffix;  // "mm"
};
std::optional<NamedChannel> parse_loose_name(const std::string& name);

// "t", "t_s", "Time", "time_ms", "Zeit": a suffix that is a unit of time is handed out.
bool is_time_name(const std::string& name, std::string& unit_suffix);

// A word, a DOF number or "base", and a mechanical unit or none, as in wobble_1_m: more than likely meant as a channel.
bool shaped_like_channel(const std::string& name);

}  // namespace host_sim
