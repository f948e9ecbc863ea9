// What lies beside the motion: mains hum, drift. It informs, or is a doubt; nothing stops.
#pragma once
#include <vector>

#include "host_sim/data_check/data_check.hpp"
#include "host_sim/data_check/measures/statistics.hpp"

namespace host_sim::data_check {

// hum: a line within 0.1 Hz of 50 or 60 Hz that stands 30 times above the mean power of its surroundings (chance: one
// in 10^12 per record and line), holds a ten-thousandth of the channel and is no harmonic of the motion (harmonic.hpp).
// A doubt where it has kHumSpoils of the mean square that the estimation makes of a motion channel, which it differentiates
// `differentiated` times (hum_weight.hpp).
// drift: the means of ten parts of an oscillating channel rise or fall steadily (correlation with time over 0.9) by more
// than 5 % of its rms.
std::vector<Finding> find_slow_faults(const Record& record, const Channel& channel, const Statistics& statistics,
                                      int differentiated);

}  // namespace host_sim::data_check
