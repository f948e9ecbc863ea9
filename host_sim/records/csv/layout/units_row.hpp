// Units that stand in a row of their own, below the names or above them.
#pragma once
#include <string>
#include <string_view>

#include "host_sim/records/csv/layout/csv_layout.hpp"

namespace host_sim {

bool has_digit_first(const std::string& field);

// Takes a row of units off the front of the data.
bool take_units(CsvLayout& layout);

// A row of units above the names, behind a word of its own as LabVIEW's Y_Unit_Label.
void find_units_above(std::string_view content, CsvLayout& layout);

}  // namespace host_sim
