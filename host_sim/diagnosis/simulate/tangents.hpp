// How steep the laws of a model are along a record's motion, which is what its steps have to be short for.
#pragma once
#include "model.hpp"

namespace diagnosis::runs {

// Neither a line nor dry friction, and without a state of its own.
bool is_curve(Kind kind);
// The steepest that such a law with coefficient one is by elongation (by_u) and by rate (by_w) over the motion between two nodes
// of a record, given as DOFs from 0; -1 the ground, -2 the base. A spring that hardens is many times as stiff far out as at rest.
LawValue steepest(Kind kind, double shape, double shape2, const Prepared& record, int a, int b);

}  // namespace diagnosis::runs
