// Of a record in parts between gaps, those that can answer something.
#pragma once
#include <string>
#include <vector>

#include "firmware/configuration/configuration.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

constexpr size_t kFewestOfPart = 4 * firmware::kBlockSamples;  // of a record: fewer make no window of the core

// Leaves out, of several parts, those at rest (no motion channel leaves one step of its values to either side), then those of fewer than
// kFewestOfPart samples, then all but the longest that the core has levels for; never all. The channels' recorded_step (their units)
// says what a step is. Returns what was left out in words, "" for nothing.
std::string leave_out_parts(std::vector<Record>& parts);

}  // namespace host_sim
