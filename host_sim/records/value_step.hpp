// The steps in which a channel's values change: those of an encoder, or of a coarse converter.
#pragma once
#include <vector>

namespace host_sim {

// The smallest step between neighbours, where all others (99 of 100 of them) are whole multiples of it within a hundredth; else
// the step that a quarter of them are, where 95 of 100 are whole multiples of it (rounded values among which a few stand in
// full). Unit of the values. 0 where they are neither.
double value_step(const std::vector<double>& values);

}  // namespace host_sim
