// From rows that lack values to rows that are whole.
#pragma once
#include "host_sim/records/csv/rows/csv_table.hpp"

namespace host_sim {

// A table beside a longer one ends before the file does: its rows without a time and a value go. Throws DataFileError where a time is
// missing before.
void leave_out_rest(CsvTable& table);

// Rows at the ends that lack a value go; one that lacks it between is refused with DataFileError, or filled where the record is to be
// interpolated.
void treat_blanks(bool interpolated, CsvTable& table);

}  // namespace host_sim
