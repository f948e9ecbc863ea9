// Whether the link or mass of an unknown moves at all: over both DOFs that it joins, the energy of its unit force adds
// up to a work that has one sign when it moves (integral of w * force(w)) and no sign when there is only noise. A force whose
// work has either sign anyway (a constant force, a damper that differs with direction) is judged by the other unknowns of
// its link; alone there, by its interval.
#pragma once
#include "firmware/identification/estimate.hpp"
#include "firmware/identification/rows/rows.hpp"

namespace firmware {

bool is_excited(const EquationList& list, const BatchTable& table, const CoreConfiguration& configuration, int unknown);

// The 95 % interval reaches further to either side than all that the number is a part of, and so tells nothing: of a damping
// coefficient all that its link dissipates (sum of |coefficient| * |work of its unit force|), of a mass or a stiffness itself.
// Friction of 0 +- 0.4 N beside a damper's 1.5 N is an answer, 0 +- 2 N is none. What reaches beyond is no measure for another.
// Not judged beside a damping coefficient that the rig file gives: its work is not in the table.
bool is_undetermined(const EquationList& list, const BatchTable& table, const CoreConfiguration& configuration,
                     int unknown, const Estimates& estimates);

}  // namespace firmware
