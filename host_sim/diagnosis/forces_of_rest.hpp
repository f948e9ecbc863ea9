// Rigs that lack what says where they rest: a constant force, a spring.
#pragma once
#include "diagnosis.hpp"
#include "first_screen/rows_say.hpp"

namespace diagnosis {

constexpr double kAllOfIt_percent = 100;  // of a signal, missed by a free run: not even its mean is right

// Whether the rig as given follows its records over any window at all.
bool describes(const Asked& asked);

// Whether it describes nothing, or a run that nothing explains misses the whole motion.
bool follows_nothing(const Diagnosis& d);

// A spring pulls towards its rest, and where a displacement counts from far off that a constant force as large as all others stands in
// the equations: a rig without the one or the other follows nothing. One that does so with them on a link lacks them. judge: says what
// it says of records, of the rig as given and of those with the forces.
Diagnosis judged_where_it_rests(const Asked& asked, Diagnosis (*judge)(const Asked&));

}  // namespace diagnosis
