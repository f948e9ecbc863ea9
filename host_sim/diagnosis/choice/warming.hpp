// Dampers that change from record to record.
#pragma once
#include "../trial/attempt.hpp"

namespace diagnosis::runs {

// All dampers that drift over the records together, without those that do not: a rig warms as a whole, and one damper
// alone explains too little of it. fit.ok is false where there is one record only, or where nothing drifts.
Attempt warming(const Task& task, const State& beside, double noise);

}  // namespace diagnosis::runs
