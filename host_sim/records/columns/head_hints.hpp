// What heads say before the columns are known: where the names stand, and what to type where none says enough.
#pragma once
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/columns/column.hpp"
#include "host_sim/records/columns/reading_options.hpp"

namespace host_sim {

// Does the head name a channel, perhaps with a foreign unit or misspelt, or a column that the user chose?
bool means_channel(const std::string& head, const rig_file::RigModel& model, const ReadingOptions& options);

// What to type for the columns whose heads are quantities' words: --column angle_1="angle" --column torque_1="torque".
std::string plain_name_hint(const std::vector<Column>& columns, const rig_file::RigModel& model);

}  // namespace host_sim
