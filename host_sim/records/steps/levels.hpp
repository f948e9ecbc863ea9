// Values of a coarse channel that were not all rounded alike.
#pragma once
#include <vector>

namespace host_sim {

// Do 95 of 100 values lie on few levels that are `unit` apart? A program that writes numbers below a thousandth in full makes two uneven
// steps of each of them, and the steps of a coarse grid that is slowly crossed may be no more than these. Of values at random 4 of
// 100 lie on a grid, and 95 never do.
bool on_few_levels(const std::vector<double>& values, double unit);

}  // namespace host_sim
