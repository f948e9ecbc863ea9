#include "host_sim/ingestion/channel_options.hpp"

#include <fmt/format.h>

#include "host_sim/records/columns/plan/column_choices.hpp"

namespace host_sim {
namespace {

std::string option_text(const char* option, const std::string& channel, const std::string& text) {
  return fmt::format("{} {}=\"{}\"", option, channel, text);
}

}  // namespace

void require_channel_options(const ColumnContext& context, const std::string& no_unit) {
  for (const auto& [channel, head] : context.options.columns) {
    if (!head.empty())
      context.refuse("has no columns with names, as " + option_text("--column", channel, head) +
                     " wants one; expected --column " + channel + "= to leave a channel out");
    if (!is_time_choice(channel)) context.require_channel(full_name(channel));
  }
  for (const auto& [channel, unit] : context.options.units) {
    const std::string said = option_text("--unit", channel, unit);
    if (is_time_choice(channel)) context.refuse(said + ": its time is in seconds, expected --sample-rate");
    context.require_channel(full_name(channel));
    if (!no_unit.empty()) context.refuse(said + ": " + no_unit);
  }
  if (!context.options.sensitivities.empty())
    context.refuse("--sensitivity is for columns of volts (CSV, MAT), which it has none of");
}

std::optional<Unit> said_unit(const ColumnContext& context, const std::string& channel, Dimension dimension) {
  for (const auto& [name, text] : context.options.units) {
    if (full_name(name) != channel) continue;
    const auto unit = find_scaled_unit(text, dimension);
    if (!unit || unit->dimension != dimension)
      context.refuse(option_text("--unit", name, text) + ": expected a unit such as " + si_unit(dimension));
    return unit;
  }
  return std::nullopt;
}

}  // namespace host_sim
