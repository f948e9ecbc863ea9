// Accelerometers whose filter rounds the jumps of dry friction.
#pragma once
#include "../choice/choice.hpp"

namespace diagnosis::runs {

// Whether a fitted model with dry friction follows its windows better, beyond chance, where accelerometers round its jumps, however
// wide. Then the records say so from here on (Prepared::rounded_over), and `fitted` is fitted anew: a friction force that
// jumps at once is read too small by the samples that are rounded away, a twentieth behind a usual anti-alias filter.
bool round_jumps(const Task& task, std::vector<Prepared>& records, State& fitted);

}  // namespace diagnosis::runs
