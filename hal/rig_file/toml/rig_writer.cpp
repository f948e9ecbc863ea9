#include "hal/rig_file/toml/rig_writer.hpp"

#include <array>
#include <charconv>

#include "hal/rig_file/toml/effect_words.hpp"

namespace rig_file {
namespace {

// The shortest text that reads back to the same double; TOML wants digits on both sides of a point.
std::string number(double value) {
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  std::string result(text.data(), end);
  if (result.find_first_of(".e") == std::string::npos) result += ".0";
  return result;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (static_cast<unsigned char>(c) >= 0x20) result += c;
  }
  return result + "\"";
}

std::string line(const std::string& key, const Coefficient& coefficient) {
  return key + " = " + (coefficient.estimate ? "\"estimate\"" : number(coefficient.value)) + "\n";
}
std::string own_line(firmware::EffectKind kind, bool rotates, const Coefficient& coefficient) {
  return coefficient.estimate || coefficient.value != 0.0 ? line(own_key(firmware::row_of(kind), rotates), coefficient)
                                                          : "";
}

std::string format_effects(const std::string& table, const std::vector<Effect>& effects) {
  std::string text;
  for (const Effect& effect : effects) {
    text += "[[" + table + ".effect]]\nkind = " + quoted(effect.kind) + "\n" + line("coefficient", effect.coefficient);
    for (const auto& [key, value] : effect.shape) text += key + " = " + number(value) + "\n";
  }
  return text;
}

std::string format_link(const RigModel& model, const Link& link) {
  using firmware::EffectKind;
  const bool rotates = link_rotates(model, link);
  const std::string second = link.b == kBase ? "\"base\"" : std::to_string(link.b);
  return "\n[[link]]\nbetween = [" + std::to_string(link.a) + ", " + second + "]\n" +
         own_line(EffectKind::kStiffness, rotates, link.stiffness_N_m) +
         own_line(EffectKind::kViscous, rotates, link.viscous_N_s_m) +
         own_line(EffectKind::kCoulomb, rotates, link.coulomb_N) +
         own_line(EffectKind::kGravityTorque, rotates, link.gravity_torque_N_m) + format_effects("link", link.effects);
}

std::string format_channel(const ChannelEntry& channel) {
  std::string text = "\n[[channel]]\nname = " + quoted(channel.name) + "\n";
  if (channel.delay_us != 0.0) text += "delay_us = " + number(channel.delay_us) + "\n";
  if (channel.ac_coupling_Hz != 0.0) text += "ac_coupling_Hz = " + number(channel.ac_coupling_Hz) + "\n";
  if (channel.unit_per_code != 0.0) text += "unit_per_code = " + number(channel.unit_per_code) + "\n";
  if (channel.offset_code != 0) text += "offset_code = " + std::to_string(channel.offset_code) + "\n";
  if (channel.lowest_code != channel.highest_code)
    text += channel.lowest_code == -channel.highest_code
                ? "full_scale_code = " + std::to_string(channel.highest_code) + "\n"
                : "lowest_code = " + std::to_string(channel.lowest_code) +
                      "\nhighest_code = " + std::to_string(channel.highest_code) + "\n";
  if (!channel.column.empty()) text += "column = " + quoted(channel.column) + "\n";
  if (!channel.unit.empty()) text += "unit = " + quoted(channel.unit) + "\n";
  if (!channel.sensitivity.empty()) text += "sensitivity = " + quoted(channel.sensitivity) + "\n";
  return text;
}

}  // namespace

std::string format_rig(const RigModel& model) {
  std::string text = "schema = \"rig/1\"\nname = " + quoted(model.name) + "\n";
  for (const Dof& dof : model.dofs)
    text += "\n[[dof]]\n" + line(own_key(firmware::row_of(firmware::EffectKind::kMass), dof.rotating), dof.mass_kg) +
            format_effects("dof", dof.effects);
  for (const Link& link : model.links) text += format_link(model, link);
  for (const ChannelEntry& channel : model.channels) text += format_channel(channel);
  return text;
}

}  // namespace rig_file
