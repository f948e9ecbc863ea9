// Displacement sensors whose zero is not where the rig rests, and another one in every record.
#pragma once
#include "../diagnosis.hpp"
#include "../first_screen/rows_say.hpp"

namespace diagnosis {

// Beside the motion of a driven rig on known springs stands the deflection under the mean force, K x = f: what a displacement's mean is
// beyond it, its sensor's zero is off by, or a constant force pushes (which name_zeros() and force_offset tell where all records have the
// same). Where nothing explains the records as they are, or a part only, and what is beyond it is a good part of the motion, they
// are judged with it taken out of each; where that explains more and a run of unseen data misses less by as much as names a cause,
// it is the answer, and the zeros are its causes: sensor_offset, with the largest of the records. judge: says what it says of records.
Diagnosis judged_with_own_zeros(const Asked& asked, Diagnosis (*judge)(const Asked&));

}  // namespace diagnosis
