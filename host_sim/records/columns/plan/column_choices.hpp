// What the user chose for columns: on the command line, and in the rig file.
#pragma once
#include <string>
#include <vector>

#include "hal/rig_file/channel_entry.hpp"
#include "hal/rig_file/channel_name.hpp"
#include "host_sim/records/columns/column.hpp"
#include "host_sim/records/columns/plan/column_context.hpp"

namespace host_sim {

bool is_time_choice(const std::string& channel);

// The rig's name for what the user calls "force_1" or "force_1_N"; as it stands where it is no channel.
std::string full_name(const std::string& channel);

// What the user chose for a channel: the command line first, then the rig file.
std::string chosen(const ReadingOptions::Choices& choices, const rig_file::RigModel& model, const std::string& channel,
                   std::string rig_file::ChannelEntry::*field);

// Whether the text names that column: by its name, or by its place from 1, "#5": names may be there twice, or empty.
bool is_head(const std::vector<Column>& columns, size_t i, const std::string& text);

// The user wants it left out: --column velocity_1=
bool is_left_out(const rig_file::ChannelName& channel, const ReadingOptions& options);

// Refuses choices of channels that the rig has not, and of columns that the file has not, or has twice.
void check_choices(const ColumnContext& context, const std::vector<Column>& columns);

}  // namespace host_sim
