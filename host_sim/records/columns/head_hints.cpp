#include "host_sim/records/columns/head_hints.hpp"

#include "hal/rig_file/channel_entry.hpp"
#include "host_sim/records/columns/names/plain_name.hpp"

namespace host_sim {

bool means_channel(const std::string& head, const rig_file::RigModel& model, const ReadingOptions& options) {
  const HeadParts parts = split_head(head);
  const auto is = [&](const std::string& text) {
    if (text.find_first_not_of("0123456789") == std::string::npos) return false;  // a place in a table without names
    return (text == parts.name || text == trimmed_text(head));
  };
  for (const auto& [channel, text] : options.columns)
    if (!text.empty() && is(trimmed_text(text))) return true;
  for (const rig_file::ChannelEntry& entry : model.channels)
    if (is(trimmed_text(entry.column))) return true;
  const auto plain = parse_plain_name(parts.name, parts.unit);
  if (model.dofs.size() <= 1 && plain && !plain->unit.empty()) return true;
  return parts.name == "t_s" || shaped_like_channel(parts.name);
}

std::string plain_name_hint(const std::vector<Column>& columns, const rig_file::RigModel& model) {
  std::string hint;
  for (const Column& column : columns) {
    const HeadParts head = split_head(column.head);
    auto plain = parse_plain_name(head.name, "");
    if (!plain) plain = parse_plain_name(head.name.substr(0, head.name.find(' ')), "");  // "Acceleration a_x"
    if (!plain || model.dofs.size() > 1) continue;
    rig_file::ChannelName channel = plain->channel;
    if (!model.dofs.empty()) channel.rotating = model.dofs[0].rotating;
    const std::string name = rig_file::format_channel_name(channel), dof = "_1";
    const std::string option = "--column " + name.substr(0, name.find(dof) + dof.size()) + "=";
    if (hint.find(option) != std::string::npos) continue;  // a quantity twice: the first of its columns
    hint += (hint.empty() ? "" : " ") + option + "\"" + trimmed_text(column.head) + "\"";
  }
  if (!hint.empty()) return hint;
  return !model.dofs.empty() && model.dofs[0].rotating ? "--column angle_1=NAME" : "--column displacement_1=NAME";
}

}  // namespace host_sim
