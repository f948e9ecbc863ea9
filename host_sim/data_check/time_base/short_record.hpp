// A record of so few samples that no command can answer from it.
#pragma once
#include <optional>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// short: a fault below 100 samples, which diagnose asks for; estimate asks for 128.
std::optional<Finding> find_short(const Record& record);

}  // namespace host_sim::data_check
