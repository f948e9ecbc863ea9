// A channel that stops for good within the record while the others go on.
#pragma once
#include <vector>

#include "host_sim/records/record.hpp"

namespace host_sim::data_check {

// For each channel the sample from which on it shows nothing but white noise; 0: it goes on, or may stop, as a drive that is switched
// off does. From one fortieth of the record to the next.
std::vector<size_t> stops_of(const Record& record);

}  // namespace host_sim::data_check
