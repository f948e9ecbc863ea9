// Stretches that stand off what is around them: spikes of one to three samples, and dropouts.
#pragma once
#include <cstddef>
#include <vector>

#include "host_sim/data_check/measures/statistics.hpp"

namespace host_sim::data_check {

struct Gap {
  size_t first = 0, width = 1;
  double size = 0.0;
};

std::vector<Gap> spikes_in(const std::vector<double>& x, const Statistics& statistics);

// At the very ends, which have neighbours on one side only: what stands off the rest by more than all that the rest spans. What
// jumps by less may be a blow in the record's first samples.
std::vector<Gap> ends_off(const std::vector<double>& x);

// Stretches of one value between jumps.
std::vector<Gap> dropouts_in(const std::vector<double>& x, const Statistics& statistics);

}  // namespace host_sim::data_check
