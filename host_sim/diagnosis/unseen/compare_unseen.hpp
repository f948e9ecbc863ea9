// Two models of a rig on data that their fits have not seen.
#pragma once
#include "../diagnosis.hpp"
#include "../windows/state.hpp"

namespace diagnosis::runs {

// Scores two models on unseen data: the rig as given and that with the causes. `noise`: mean square of each
// channel's. Returns the second's worst NRMSE in percent where a channel shows motion beyond it.
double compare_unseen(const Task& task, const State& base, const State& with_causes, bool any_cause, const Vec& noise,
                      Diagnosis& d);

}  // namespace diagnosis::runs
