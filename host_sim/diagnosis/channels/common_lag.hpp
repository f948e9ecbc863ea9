// Motion channels that all lag the force alike.
#pragma once
#include "../choice/choice.hpp"
#include "../diagnosis.hpp"

namespace diagnosis::runs {

// A force channel that reads early is none: nothing is read before it happens. Where all motion channels lag the force by
// what an anti-alias filter in front of them alone does, that is said, stays taken out of the numbers and the extended rig, and
// is no cause. Returns it, s; 0 where there is none.
double say_common_lag(const Task& task, Diagnosis& d);

}  // namespace diagnosis::runs
