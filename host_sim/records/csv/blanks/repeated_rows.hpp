// Rows that stand twice in a table.
#pragma once
#include "host_sim/records/csv/rows/csv_table.hpp"

namespace host_sim {

// They are left out where, of the rows that bear the time of the one before, all are it word by word, and they are many.
void leave_out_repeats(CsvTable& table);

}  // namespace host_sim
