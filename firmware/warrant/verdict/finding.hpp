// What a probe of the score tests says of the rig: cause, place, which channel is off, size and deviation.
#pragma once
#include "firmware/warrant/scores/score_test.hpp"

namespace firmware {

// probe: a candidate of the plan, -1: none (an empty finding). Size and std in the unit of the cause's first parameter
// (firmware/vocabulary/effect_table.hpp); a channel's gain less 1, a delay in s. Two channels of a DOF that contradict each other:
// the one that is off, by the DOF's third channel or the springs beside it.
Finding finding_of(const CoreConfiguration& configuration, const Estimates& estimates, const ProbePlan& plan,
                   const ScoreTest& test, int probe);

}  // namespace firmware
