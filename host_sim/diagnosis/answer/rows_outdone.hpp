// Causes of the rows against those that the free runs know.
#pragma once
#include "../choice/choice.hpp"
#include "../diagnosis.hpp"

namespace diagnosis::runs {

// Whether one cause that the rows cannot name (a dead band of the drive, cogging, a missing gravity torque) follows the windows
// clearly better than their cause does, or as well as their several; or dry friction follows them as well as their friction that
// falls with the rate. with_them: fitted with the rows' causes beside the rig as given, fitted.base.
bool outdone(const Task& task, const Choice& fitted, const std::vector<Candidate>& causes, const State& with_them);

// Rows take the forces that they compare from the measured motion, with its noise, and do not take all with as much of it. Where that is
// much of the motion: what stands as well as their one cause in the runs, which take no noise, is listed beside it. False where the
// runs name another in its place.
bool stands_in_noise(const Task& task, const Choice& fitted, const Candidate& cause, const State& with_it,
                     std::vector<NamedPlace>& as_good);

}  // namespace diagnosis::runs
