// Causes that others have made needless.
#pragma once
#include "../choice/choice.hpp"

namespace diagnosis::runs {

// Of the rig's error as given, what all the motion would make: more than all where the rig is about right, a part of it where a constant
// force is the error.
double motion_over_error(const Task& task, const State& base);

// What a further cause takes of the rig's error as given is less than a share of what the others take, of the motion at most.
bool takes_little(double error_before, double error_with, double motion);

// Drops causes that the later ones have made needless: without them the windows are followed as well, as far as chance can tell, or so
// nearly that as further causes they would not have been named. None goes whose place another could take only by a shape that
// the records cannot show: a sine of which less than its pitch is travelled bends as the quadratic spring beside it does.
void drop_needless(const Task& task, const State& base, State& now, std::vector<Named>& named);

// Bristles whose own damping came out as none, a thousandth of the time that they take to bend, have none: a number that is nothing is not told.
void drop_idle_damping(const Task& task, State& now, std::vector<Named>& named);

}  // namespace diagnosis::runs
