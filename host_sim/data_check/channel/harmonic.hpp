// Lines of a channel that are harmonics of its motion: friction, a gap, a bent sine make all of a series.
#pragma once
#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// Whether a line is a multiple of the channel's strongest tone, and another multiple beside it (one or two before or after)
// is a third of it and more. Mains hum stands alone.
bool is_harmonic(const Channel& channel, double mean, double sample_period_s, double line_Hz);

}  // namespace host_sim::data_check
