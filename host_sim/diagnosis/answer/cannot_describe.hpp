// A rig file that is no model of the records.
#pragma once
#include "../choice/choice.hpp"
#include "../diagnosis.hpp"

namespace diagnosis::runs {

// Windows shorter than a period follow anything from their own states: what is noise there need not be over the records.
bool windows_tell(const Task& task, const Choice& choice);

// Of every DOF the free runs of unseen data miss four fifths of the variance. Where windows do no better, or are so short that they follow
// anything, nothing of the motion is known, whatever noise hides; and no number is. d: compared with unseen data.
bool follows_nothing(const Task& task, const Choice& choice, const Diagnosis& d);

// Says so, and takes the numbers back, which are of a model that is not this rig's.
void say_cannot_describe(const Task& task, const Choice& choice, Diagnosis& d);

}  // namespace diagnosis::runs
