#include "host_sim/records/columns/plan/column_choices.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host_sim/records/columns/quoted.hpp"

namespace host_sim {
namespace {

// A number where a name is wanted: of a column, most likely.
bool is_count(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

bool is_time_choice(const std::string& channel) { return channel == "t" || channel == "t_s" || channel == "time"; }

std::string full_name(const std::string& channel) {
  if (rig_file::parse_channel_name(channel)) return channel;
  const auto loose = parse_loose_name(channel);
  return loose && loose->suffix.empty() ? rig_file::format_channel_name(loose->channel) : channel;
}

std::string chosen(const ReadingOptions::Choices& choices, const rig_file::RigModel& model, const std::string& channel,
                   std::string rig_file::ChannelEntry::*field) {
  for (const auto& [name, text] : choices)
    if (full_name(name) == channel) return text;
  const rig_file::ChannelEntry* const entry = rig_file::entry_of(model, channel);
  return entry == nullptr ? "" : entry->*field;
}

bool is_head(const std::vector<Column>& columns, size_t i, const std::string& text) {
  const Column& column = columns[i];
  if (text == "#" + std::to_string(i + 1)) return true;
  return trimmed_text(column.head) == trimmed_text(text) || split_head(column.head).name == trimmed_text(text);
}

bool is_left_out(const rig_file::ChannelName& channel, const ReadingOptions& options) {
  return std::any_of(options.columns.begin(), options.columns.end(), [&](const auto& choice) {
    return choice.second.empty() && full_name(choice.first) == rig_file::format_channel_name(channel);
  });
}

void check_choices(const ColumnContext& context, const std::vector<Column>& columns) {
  for (const auto& [channel, head] : context.options.columns) {
    if (!is_time_choice(channel)) context.require_channel(full_name(channel));
    if (head.empty()) continue;
    std::vector<size_t> found;
    for (size_t i = 0; i < columns.size(); ++i)
      if (is_head(columns, i, head)) found.push_back(i + 1);
    if (found.size() == 1) continue;
    if (!found.empty())
      context.refuse(fmt::format("has {} columns {} for {}, expected one: take it by its place, {}=#{} or {}=#{}",
                                 found.size(), quoted(head), channel, channel, found[0], channel, found[1]));
    context.refuse("has no column " + quoted(head) + " for " + channel + ", expected one of " + quoted_heads(columns) +
                   (is_count(head) ? ", or a place: " + channel + "=#" + head : ""));
  }
  for (const auto* choices : {&context.options.units, &context.options.sensitivities})
    for (const auto& [channel, text] : *choices)
      if (!is_time_choice(channel)) context.require_channel(full_name(channel));
}

}  // namespace host_sim
