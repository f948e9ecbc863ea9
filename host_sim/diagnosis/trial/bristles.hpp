// Friction whose bristles bend, and what is taken for it.
#pragma once
#include "attempt.hpp"

namespace diagnosis::runs {

// Whether one fitted cause is friction whose bristles bend; and the same with friction that does not, fitted from there: over
// long windows the error of dry friction has valleys of its own, which bristles lead around. Where they act in the place
// of the rig's own friction that is the model beside which they were put, and no cause.
bool is_bristles(const Attempt& a);
Attempt without_bristles(const Task& task, const State& beside, const Attempt& bristles);
// Bristles that were fitted, with a damping of their own (LuGre) that starts where it takes as long as they take to bend. One
// question is asked: does it leave less than chance would? Beside its rivals it is the same cause: none is simpler for that.
Attempt damped(const Task& task, const State& beside, Attempt bristles);
// Beside the rounding of frictions that is significant among those tried, all of it together; no fit where there is none.
State rounded(const Task& task, const State& beside, const std::vector<Attempt>& tried);

}  // namespace diagnosis::runs
