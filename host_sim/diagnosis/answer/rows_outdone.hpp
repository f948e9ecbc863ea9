// Causes of the rows against those that only the free runs know.
#pragma once
#include "../choice/choice.hpp"

namespace diagnosis::runs {

// Whether one cause that the rows cannot name (a dead band of the drive, cogging, a missing gravity torque) follows the windows
// clearly better than their cause does, or as well as their several; or dry friction follows them as well as their friction that
// falls with the rate. with_them: fitted with the rows' causes beside the rig as given, fitted.base.
bool outdone(const Task& task, const Choice& fitted, const std::vector<Candidate>& causes, const State& with_them);

}  // namespace diagnosis::runs
