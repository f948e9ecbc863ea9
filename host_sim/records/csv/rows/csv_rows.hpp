// The rows of a table, from its first to where it ends.
#pragma once
#include "host_sim/records/csv/rows/csv_table.hpp"

namespace host_sim {

// Of a table whose targets are found. Comment lines are passed over; a blank line, text below the numbers or a last line that breaks
// off end it.
void read_rows(CsvTable& table);

}  // namespace host_sim
