// Causes that fit, and with which nobody could predict.
#pragma once
#include "../diagnosis.hpp"

namespace diagnosis::runs {

// Takes all causes back where the simulation of what is unseen misses half as much again with them, of the worst DOF, as the rig as given
// does: Diagnosis::rejected. Windows are short, and a fit that they like may leave for elsewhere (a coefficient of the wrong sign). The
// verdict is unknown then, and the rig as given stands.
void reject_what_simulates_worse(const rig_file::RigModel& rig, Diagnosis& d);

}  // namespace diagnosis::runs
