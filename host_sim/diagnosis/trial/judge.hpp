// What a settled attempt brings.
#pragma once
#include "attempt.hpp"

namespace diagnosis::runs {

// What a settled attempt brings, and whether chance could bring it. hosted: some cause of it acts in another's place.
void judge(const Task& task, const State& beside, bool hosted, Attempt& a);

}  // namespace diagnosis::runs
