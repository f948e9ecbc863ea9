// The end of a file that a logger has not closed.
#pragma once
#include <string_view>

#include "host_sim/records/csv/rows/csv_table.hpp"
#include "host_sim/records/csv/rows/field_format.hpp"

namespace host_sim {

// The file's end within a line, as a logger leaves it that was switched off: no line end behind it, and fewer fields than columns, or
// a last number that is none yet ("1.5e-") or is shorter than in all of the rows before it (of which there are enough).
bool breaks_off(std::string_view row, const CsvTable& table, const FieldFormat& format);

}  // namespace host_sim
