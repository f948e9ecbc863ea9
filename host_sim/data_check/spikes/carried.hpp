// Other channels that were computed from one with spikes, and have them too.
#pragma once
#include <vector>

#include "host_sim/data_check/spikes/gaps.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim::data_check {

// What spikes of a displacement or velocity leave in a velocity or acceleration of the same DOF.
struct Carried {
  const Channel* channel = nullptr;  // the one that has most of it
  double harm = 1.0;                 // by which its mean square is too large
};

// A sensor of its own knows nothing of another's spike. A column that a program has differentiated has it over the width of its filter:
// up to 8 samples to either side are looked at. What is there counts where its mean square is over four times that of the 64 samples
// before and of those behind: a swing has twice its mean square at its turn, two that beat have four times, a release is as loud behind.
// At two of the spikes it has to, unless there is but one: one may meet a blow. Where a force strikes, nothing is looked at: there the motion is as sudden.
Carried carried(const Record& record, const Channel& channel, const std::vector<Gap>& gaps);

}  // namespace host_sim::data_check
