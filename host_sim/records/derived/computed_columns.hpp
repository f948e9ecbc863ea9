// Columns that were computed from others of the same DOF: the slope of a displacement beside it, its second differences, the slope of a
// velocity, the sum of an acceleration. They measure nothing, and have the noise of what they were made from: as readings of their own
// they would count it twice, and their differences lag or lose what a sensor's would not.
#pragma once
#include "host_sim/records/record.hpp"

namespace host_sim {

// Leaves them out of the record, with its name in Record::computed and a note for each that says what it is. A column counts as computed where it is the other's
// difference (forward, backward, central, with uneven steps as with even ones; twice for an acceleration), or the other its sum by the
// trapezoidal or the rectangular rule, by less than kOwn of the noise that the difference makes of the other's: a sensor of its own,
// however good, cannot follow another one's noise. So is one that follows the rounding of the other (of_rounding.hpp). Only records with the file's own rows: before they are interpolated.
void leave_out_computed(Record& record);

}  // namespace host_sim
