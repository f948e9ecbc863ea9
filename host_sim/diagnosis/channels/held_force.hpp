// A force that is held between its samples, where the motion shows more of it than a delay.
#pragma once
#include "../choice/choice.hpp"

namespace diagnosis::runs {

// Whether the rig as given follows its records clearly better with forces that stay at their samples until the next ones, and better
// than with any delay of a force or of a channel where one acts; also beside the one cause of the vocabulary that explains more, if one
// does (a wrong spring makes motion late too). Then the records say so from here on (Prepared::held). An
// accelerometer shows the steps themselves; noisy displacements and velocities show no more than a force that is late by half a
// sample: that is name_holds()'s.
bool held_force(const Task& task, std::vector<Prepared>& records, const Choice& choice);

}  // namespace diagnosis::runs
