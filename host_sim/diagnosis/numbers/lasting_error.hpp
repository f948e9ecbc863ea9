// How far a lasting error of the forces that drive a rig may have moved its numbers.
#pragma once
#include "../windows/state.hpp"

namespace diagnosis::runs {

// As determined(), beside elastic_doubt(), and wider where a force is much noise (a measured torque): what makes such noise is not right on the mean
// either, and no scatter between windows shows it. Any error of up to an eighth of the noise, lasting as long as a window and each
// window its own, is within the interval.
std::vector<Determined> determined_beside_drives(const Task& task, const State& state);

}  // namespace diagnosis::runs
