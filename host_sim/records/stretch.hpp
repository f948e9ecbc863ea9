// A stretch of a record.
#pragma once
#include <cstddef>

#include "host_sim/records/record.hpp"

namespace host_sim {

// Samples [first, end), with their start and their number in the file.
Record stretch_of(Record record, size_t first, size_t end);

}  // namespace host_sim
