// What the user says of channels (--column, --unit, --sensitivity), of files whose channels are no columns with names: Universal Files
// and CAN logs.
#pragma once
#include <optional>
#include <string>

#include "host_sim/records/columns/plan/column_context.hpp"
#include "host_sim/records/columns/units/units.hpp"

namespace host_sim {

// Refuses what such a file has no use for, and channels that the rig has not: to pass it over would be to read other numbers than the
// user wants. no_unit: why it takes none; empty: it does.
void require_channel_options(const ColumnContext& context, const std::string& no_unit);

// The unit that the user says a channel is in. Refuses one of another dimension.
std::optional<Unit> said_unit(const ColumnContext& context, const std::string& channel, Dimension dimension);

}  // namespace host_sim
