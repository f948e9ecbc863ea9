// Writes a record as CSV in the format that csv_reader reads; numbers read back to the same double.
#pragma once
#include <string>

#include "host_sim/records/record.hpp"

namespace host_sim {

std::string format_csv(const Record& record);

}  // namespace host_sim
