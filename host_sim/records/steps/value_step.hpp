// The steps in which a channel's values change: those of an encoder, or of a coarse converter.
#pragma once
#include <vector>

#include "host_sim/records/record.hpp"

namespace host_sim {

// The smallest step between neighbours, where all others (99 of 100 of them) are whole multiples of it within a hundredth; else
// the step that a quarter of them are, where 95 of 100 are whole multiples of it (rounded values among which a few stand in
// full); else the unit of which all are multiples but for the last decimal that they were written to. Unit of the values. 0
// where they are none of it.
double value_step(const std::vector<double>& values);

// The same of a channel: of interpolated values, in which no step shows, the one in which they were recorded.
double value_step(const Channel& channel);

}  // namespace host_sim
