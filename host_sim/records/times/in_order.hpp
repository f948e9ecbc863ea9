// Many sizes sorted.
#pragma once
#include <vector>

namespace host_sim {

// The same numbers, the smallest first; none of them is negative, NaN or infinite. Quick where they are spread as the steps of measured
// signals are; where many lie close together it is a pass over them and boost's float_sort.
std::vector<double> in_order(const std::vector<double>& values);

}  // namespace host_sim
