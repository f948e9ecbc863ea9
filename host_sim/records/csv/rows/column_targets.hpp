// Where the columns of a table go: from what they mean to the record's channels and the times.
#pragma once
#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/columns/reading_options.hpp"
#include "host_sim/records/csv/rows/csv_table.hpp"

namespace host_sim {

// Of a table whose layout is known. Throws DataFileError where it has no channel, or nothing tells the times.
void find_targets(const rig_file::RigModel& model, const ReadingOptions& options, CsvTable& table);

}  // namespace host_sim
