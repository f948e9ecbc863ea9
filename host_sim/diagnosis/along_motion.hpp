// Motions that something else than the measured force holds: a joint that a controller turns at speeds.
#pragma once
#include "diagnosis.hpp"
#include "first_screen/rows_say.hpp"

namespace diagnosis {

// Nothing pulls a simulation of such a rig back to what was measured: a force that is off by little, or late, runs astray in a second, and a
// mass that is too large, which keeps its speed whatever acts on it, follows best. Where free runs explain nothing of a rig that no
// spring holds, what `judge` says of the forces along the motion as measured: force less known mass times acceleration of each DOF. A
// mass that the rig file leaves open is fitted with the forces. The same where gravity alone holds it and free runs run away: an arm that stands
// on its weight. It is told where it follows the forces, or halves what is missed of them; else what free runs say.
// Diagnosis::along_motion says which.
Diagnosis judged_along_the_motion(const Asked& asked, Diagnosis (*judge)(const Asked&));

}  // namespace diagnosis
