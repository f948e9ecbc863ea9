// Motions that something else than the measured force holds: a joint that a controller turns at speeds.
#pragma once
#include "diagnosis.hpp"
#include "first_screen/rows_say.hpp"

namespace diagnosis {

// Nothing pulls a simulation of such a rig back to what was measured: a force that is off by little, or late, runs astray in a second, and a
// mass that is too large, which keeps its speed whatever acts on it, follows best. Where free runs explain nothing of a rig that no
// spring holds, what `judge` says of the forces along the motion as measured: force less mass times acceleration of each DOF, and no
// mass. A mass that the rig file leaves open is the one that balances the forces. It is told where it names a cause and its force is
// missed by half on unseen data at most; else what free runs say. Diagnosis::along_motion says which.
Diagnosis judged_along_the_motion(const Asked& asked, Diagnosis (*judge)(const Asked&));

}  // namespace diagnosis
