// Records that no command answers from together: other rates, other channels.
#pragma once
#include <vector>

#include "host_sim/data_check/data_check.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim::data_check {

// unlike: each record whose sample period or channels differ from the first one's, and what to do. A doubt: each may be good alone.
std::vector<Finding> find_unlike(const std::vector<Record>& records);

}  // namespace host_sim::data_check
