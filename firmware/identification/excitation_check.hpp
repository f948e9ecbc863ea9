// Whether the link or mass of an unknown moves at all: over both DOFs that it joins, the energy of its unit force adds
// up to a work that has one sign when it moves (integral of w * force(w)) and no sign when there is only noise. A force whose
// work has either sign anyway (a constant force, a damper that differs with direction) is judged by the other unknowns of
// its link; alone there, by its interval.
#pragma once
#include "firmware/identification/rows.hpp"

namespace firmware {

bool is_excited(const EquationList& list, const BatchTable& table, const CoreConfiguration& configuration, int unknown);

}  // namespace firmware
