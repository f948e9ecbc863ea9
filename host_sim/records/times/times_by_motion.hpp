// Times that may have been rounded, or may be right as they stand: what was recorded at them knows.
#pragma once
#include <vector>

#include "host_sim/records/record.hpp"

namespace host_sim {

// Whether samples `first` on of the record, as many as there are times, make a clearly smoother motion at the times as they are given than
// at those that were made even. Steps of 10 and 11 ms in turn are what a clock of whole milliseconds makes of 10.5 ms, and what a loop with
// two tasks really does; a motion times half a millisecond shows as noise where the wrong one of both is taken (noise_variance.hpp). False
// where its own noise hides that: either will do then.
bool smoother_as_given(const Record& record, size_t first, const std::vector<double>& given_s,
                       const std::vector<double>& even_s);

}  // namespace host_sim
