// What is said of columns that are nothing to the rig.
#pragma once
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/columns/column.hpp"
#include "host_sim/records/columns/column_meaning.hpp"

namespace host_sim {

// Notes them, and where no force is read one of them that is in a unit of force.
void note_ignored(const rig_file::RigModel& model, const std::vector<Column>& columns, ColumnPlan& plan);

}  // namespace host_sim
