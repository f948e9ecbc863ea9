// The steps in which a channel's values change: those of an encoder, or of a coarse converter.
#pragma once
#include <vector>

namespace host_sim {

// The smallest step between neighbours, where all others (99 of 100 of them) are whole multiples of it within a hundredth;
// unit of the values. 0 where they are not.
double value_step(const std::vector<double>& values);

}  // namespace host_sim
