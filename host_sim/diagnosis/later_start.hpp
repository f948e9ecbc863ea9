// Free motions that begin with something that the rig file has not: a hand that pulls on, faster modes of a blow.
#pragma once
#include "diagnosis.hpp"
#include "first_screen/rows_say.hpp"

namespace diagnosis {

// Where the rig file describes nothing of free motions from their start, or a run that nothing explains misses all of them: what `judge`
// says of them from a later start, the earliest of a few from which something is known, or else which it describes. Where their start is cut
// off already and something is left: from the first later start that leaves nothing. Diagnosis::told_from_s says from where. Else, and
// where a force acts or no spring holds the rig, what it says of all.
Diagnosis judged_from_a_later_start(const Asked& asked, Diagnosis (*judge)(const Asked&));

}  // namespace diagnosis
