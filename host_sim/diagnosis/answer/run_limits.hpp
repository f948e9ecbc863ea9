// Detection limits of the free runs, which have to bear out what the rows name.
#pragma once
#include "answer.hpp"

namespace diagnosis::runs {

// Raises the rows' limits to what the runs over the windows would bear out in 95 of 100 such records, beside the causes that `base` has.
void raise_limits(const Task& task, const State& base, std::vector<DetectionLimit>& limits);
// The limits of the runs alone, where no rows were asked: of every law without a shape, at every place. Infinite where the fitted
// numbers of the rig make the same motion (a spring beside an unknown mass, at one frequency).
std::vector<DetectionLimit> limits_of_runs(const Task& task, const State& base);

}  // namespace diagnosis::runs
