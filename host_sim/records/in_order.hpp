// Many numbers sorted by size.
#pragma once
#include <vector>

namespace host_sim {

// The same numbers, the smallest first; none of them NaN or infinite. Quick where they are spread as those of measured signals are,
// never slower than std::sort by more than a pass over them.
std::vector<double> in_order(const std::vector<double>& values);

}  // namespace host_sim
