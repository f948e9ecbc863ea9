// A rig that has little to set the scale of its numbers.
#pragma once
#include "../choice/choice.hpp"
#include "../diagnosis.hpp"

namespace diagnosis::runs {

// The equations of motion hold as well with every mass, spring, damper and force r times as large. Where two things alone set that scale (a
// known mass and a known spring where no force is measured, or the one known number and the force), an error of the one is an
// error of the other: where one is named the other is its equal, and all unknown numbers hang on which it is.
void say_scale(const Task& task, Diagnosis& d);

}  // namespace diagnosis::runs
