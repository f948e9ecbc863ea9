// How far elastic forces that are not quite right may have moved a fit's numbers.
#pragma once
#include "../windows/state.hpp"

namespace diagnosis::runs {

// Per parameter of the model, a standard deviation: what a share kKnownElastic of the elastic forces at its place would be taken for, were it
// all in phase with it. It is the same in every window, so that no scatter between them shows it: the intervals of records
// with hardly any noise are as wide as this. Of shapes, and of effects that the rig file does not have: 0.
Vec elastic_doubt(const Task& task, const Model& model);

}  // namespace diagnosis::runs
