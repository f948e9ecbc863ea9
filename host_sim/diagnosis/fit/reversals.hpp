// Where a motion turns round.
#pragma once
#include "../motion/prepared.hpp"
#include "../terms/terms.hpp"

namespace diagnosis::runs {

// DOFs x samples: 1, or 0 where a link on the DOF moves so slowly that the next sample may be beyond its reversal, or that noise of its
// rate hides which way it moves: dry friction is anything between its two values there, and a force that is read says nothing of it.
Mat directions_known(const System& system, const Prepared& record);

}  // namespace diagnosis::runs
