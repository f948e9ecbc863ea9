// Rigs whose displacements count from far off their rest.
#pragma once
#include "diagnosis.hpp"
#include "first_screen/rows_say.hpp"

namespace diagnosis {

// Whether the rig as given follows its records over any window at all.
bool describes(const Asked& asked);

// A spring pulls towards its rest: where a displacement counts from far off it, a constant force as large as all others stands in the
// equations, and a rig without it follows nothing. One that does so with such a force on a link lacks that. judge: says what it says of
// records, of the rig as given and of that with the force.
Diagnosis judged_off_its_zero(const Asked& asked, Diagnosis (*judge)(const Asked&));

}  // namespace diagnosis
