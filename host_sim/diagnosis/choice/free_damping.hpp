// The damping of hidden masses, once they are in the model.
#pragma once
#include "../windows/state.hpp"

namespace diagnosis::runs {

// Candidates are tried with one damping ratio for all; a mass that has been chosen gets its own, where that leaves less of
// what is fitted and no more of unseen windows: true then.
bool free_damping(const Task& task, State& with);

}  // namespace diagnosis::runs
