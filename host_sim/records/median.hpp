// The middle of many numbers.
#pragma once
#include <vector>

namespace host_sim {

// The one that as many are below as above; of an even number the upper of the two in the middle. 0 where there is none.
double median(std::vector<double> values);

}  // namespace host_sim
