// Sample times that scatter about even steps.
#pragma once
#include <optional>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// jitter: the file's sample times scatter about even steps by more than a thousandth of a step, rounding left out.
std::optional<Finding> find_jitter(const Record& record);

}  // namespace host_sim::data_check
