// How far two models of a rig differ in the forces that they give, whichever of their terms makes them.
#pragma once
#include "../windows/state.hpp"

namespace diagnosis::runs {

// The largest change, as a share, of what resists the rates of a link, of what resists its elongation, and of a DOF's
// inertia, along the motion of the fitted records. Terms that look alike (viscous, quadratic and dry friction of one
// link) may share a force in other ways and change nothing.
double laws_apart(const Task& task, const Model& before, const Model& after);

}  // namespace diagnosis::runs
