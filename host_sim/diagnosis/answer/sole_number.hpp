// A rig of which one number alone is known: the scale of all others.
#pragma once
#include "answer.hpp"

namespace diagnosis::runs {

// Where one mass or one spring is all that is known, and one force alone drives the rig, an error of that number and the gain of the force
// are the same: a force that reads r times too much makes every number r times as large. Where one of them is named the other
// is its equal.
void say_sole_number(const Task& task, Diagnosis& d);

}  // namespace diagnosis::runs
