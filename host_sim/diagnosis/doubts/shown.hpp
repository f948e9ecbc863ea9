// Whether records can show what a fitted term says.
#pragma once
#include "../windows/state.hpp"

namespace diagnosis::runs {

constexpr double kTrifle = 2e-4;  // of what is given: no balance, spring tester or calibration of a rig is better

// False for bristles that bend within a sample or all along their link's way, for a dead band that the force hardly leaves, for a
// hidden mass that is a trifle of its DOF's, for a damper that has settled before it can be seen to drift, for a pitch of which the way
// holds too little to see it repeat, and for a channel's gain that the next quantity of its DOF contradicts.
bool shown(const Task& task, const ModelTerm& term);
// Of every cause that a model has beside the rig as given: fitted anew, a shape may have gone where nothing shows it.
bool all_shown(const Task& task, const Model& model);

}  // namespace diagnosis::runs
