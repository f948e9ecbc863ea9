// What may be there where nothing is named.
#pragma once
#include "../choice/choice.hpp"
#include "../diagnosis.hpp"

namespace diagnosis::runs {

// Causes that may be there, and which numbers of the rig as given they would take out of their intervals. Where none is and nothing
// explains what is left, what comes nearest: it bends no number that is not withdrawn already.
void say_possible(const Task& task, const Choice& choice, Diagnosis& d);

}  // namespace diagnosis::runs
