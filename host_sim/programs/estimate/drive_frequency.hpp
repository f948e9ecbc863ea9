// Whether records are driven at the frequency that --frequency says.
#pragma once
#include <string>
#include <vector>

#include "host_sim/records/record.hpp"

namespace host_sim {

// The share of a series' variance that a frequency and its harmonics hold (0 to 1), eight cycles at a time, so that a frequency known
// to a few per cent finds its own. 0 of what is shorter than a cycle.
double share_at(const std::vector<double>& values, double sample_period_s, double frequency_Hz);

// A note on each record most of whose drive lies elsewhere: its force, or the motion of its base, or where nothing drives it its
// motion. None where --frequency is right.
std::vector<std::string> doubt_frequency(const std::vector<Record>& records, double frequency_Hz);

}  // namespace host_sim
