// One signal under two names: a column copied, a channel wired or logged twice.
#pragma once
#include <vector>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// A fault for each motion channel that has, sample by sample, the very values of another DOF's channel of that quantity. Two
// sensors never agree like that: their noise differs, and steps of two encoders fall at different times. At least 20 changes of
// the value are asked for: where each of two equal motions changes at a moment of its own, one in a thousand chances to agree.
std::vector<Finding> find_duplicates(const Record& record);

}  // namespace host_sim::data_check
