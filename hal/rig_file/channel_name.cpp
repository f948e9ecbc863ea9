#include "hal/rig_file/channel_name.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <vector>

#include "hal/rig_file/toml/toml_checks.hpp"

namespace rig_file {
namespace {

using firmware::Quantity;

struct Pattern {
  Quantity quantity;
  bool rotating;
  const char* stem;
  const char* unit;
};
constexpr Pattern kPatterns[] = {
    {Quantity::kForce, false, "force_", "_N"},
    {Quantity::kDisplacement, false, "displacement_", "_m"},
    {Quantity::kVelocity, false, "velocity_", "_m_s"},
    {Quantity::kAcceleration, false, "acceleration_", "_m_s2"},
    {Quantity::kForce, true, "torque_", "_N_m"},
    {Quantity::kDisplacement, true, "angle_", "_rad"},
    {Quantity::kVelocity, true, "angular_velocity_", "_rad_s"},
    {Quantity::kAcceleration, true, "angular_acceleration_", "_rad_s2"},
};

// The DOF in the middle of the name, 0 where there is none.
int parse_dof(std::string_view middle) {
  if (middle == "base") return kBase;
  int dof = 0;
  const auto [end, error] = std::from_chars(middle.data(), middle.data() + middle.size(), dof);
  const bool whole = error == std::errc() && end == middle.data() + middle.size();
  return whole && dof >= 1 && middle.front() != '0' ? dof : 0;
}

// Without a rig file: those of the DOF that the name tells.
std::vector<std::string> names_like(const std::string& name) {
  const size_t first = name.find_first_of("123456789");
  const int dof = first == std::string::npos ? 1 : std::atoi(name.c_str() + first);
  std::vector<std::string> names;
  for (const Pattern& pattern : kPatterns)
    names.push_back(format_channel_name({pattern.quantity, std::min(dof, 16), pattern.rotating}));
  return names;
}

// "disp_1_m" as displacement_1_m: a quantity's word may be cut short.
std::string in_full(const std::string& name) {
  const size_t word = name.find('_');
  if (word == std::string::npos || word < 3) return name;
  for (const Pattern& pattern : kPatterns)
    if (std::string_view(pattern.stem).substr(0, word) == std::string_view(name).substr(0, word))
      return pattern.stem + name.substr(word + 1);
  return name;
}

std::vector<std::string> usable_names(const RigModel& model) {
  std::vector<std::string> names;
  const bool base_rotates = !model.dofs.empty() && model.dofs.front().rotating;
  for (int dof = kBase; dof <= static_cast<int>(model.dofs.size()); ++dof) {
    if (dof == kGround) continue;
    const bool rotates = dof == kBase ? base_rotates : model.dofs[static_cast<size_t>(dof - 1)].rotating;
    for (const Pattern& pattern : kPatterns)
      if (pattern.rotating == rotates && !(dof == kBase && pattern.quantity == Quantity::kForce))
        names.push_back(format_channel_name({pattern.quantity, dof, rotates}));
  }
  return names;
}

}  // namespace

std::optional<ChannelName> parse_channel_name(const std::string& name) {
  const std::string_view whole = name;
  for (const Pattern& pattern : kPatterns) {
    const std::string_view stem = pattern.stem, unit = pattern.unit;
    if (whole.size() <= stem.size() + unit.size() || whole.substr(0, stem.size()) != stem) continue;
    if (whole.substr(whole.size() - unit.size()) != unit) continue;
    const int dof = parse_dof(whole.substr(stem.size(), whole.size() - stem.size() - unit.size()));
    if (dof != 0 && !(dof == kBase && pattern.quantity == Quantity::kForce))
      return ChannelName{pattern.quantity, dof, pattern.rotating};
  }
  return std::nullopt;
}

std::string format_channel_name(const ChannelName& channel) {
  for (const Pattern& pattern : kPatterns)
    if (pattern.quantity == channel.quantity && pattern.rotating == channel.rotating)
      return pattern.stem + (channel.dof == kBase ? "base" : std::to_string(channel.dof)) + pattern.unit;
  return "";
}

std::string channel_name_fault(const std::string& name, const RigModel& model) {
  const std::string dof_range = "1 to " + std::to_string(model.dofs.size());
  const auto channel = parse_channel_name(name);
  if (!channel) {
    const std::string near = nearest_word(in_full(name), model.dofs.empty() ? names_like(name) : usable_names(model));
    return "is not a channel name; " + (near.empty() ? "e" : "did you mean \"" + near + "\"? E") +
           "xpected quantity, DOF and unit, such as displacement_1_m";
  }
  if (channel->dof == kBase) {
    const bool used =
        std::any_of(model.links.begin(), model.links.end(), [](const Link& link) { return link.b == kBase; });
    return used ? "" : "is of a moving base, but no link of the rig ends on \"base\"; expected DOF " + dof_range;
  }
  if (channel->dof > static_cast<int>(model.dofs.size()))
    return "is of DOF " + std::to_string(channel->dof) + ", which the rig does not have; expected " + dof_range;
  const bool rotates = model.dofs[static_cast<size_t>(channel->dof - 1)].rotating;
  if (rotates != channel->rotating)
    return "DOF " + std::to_string(channel->dof) + (rotates ? " rotates" : " translates") + ", expected " +
           format_channel_name({channel->quantity, channel->dof, rotates});
  return "";
}

}  // namespace rig_file
