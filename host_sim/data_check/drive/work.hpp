// The work that the forces do on the rig. A rig has no source of its own: over a record its dampers take, never give.
#pragma once
#include <optional>

#include "host_sim/data_check/data_check.hpp"
#include "host_sim/data_check/drive/excitation.hpp"

namespace host_sim::data_check {

// Of all forces together, each with the velocity of its DOF, averaged alike over a quarter of the drive's shortest period.
// A DOF with acceleration alone has it with the force's rate instead: the real part of a driving-point mobility is not
// negative at any frequency, so no weight over frequency makes it so.
// polarity: the power factor is below -0.5. A late channel alone would have to be late by a twelfth of a period. A fault
// of several forces; of a single one a doubt, for its sign against the motions is all there is to change.
// work, a doubt: it is negative, by more.
// Both about the means, for the zero of a sensor may be off, and as measured, for a rig that goes on one way is driven by the mean: what a
// controller does about its speed brakes and pushes against what disturbs it. Of the power as measured the sign counts, for `polarity` half
// of the same rms values. Where only the power as measured is negative (power factor below -0.5), `work` says so of a single force: an
// offset explains that, too. Nothing of a rig that goes on one way more and more slowly: its flywheel gives what it had.
// All only where ten parts of the record agree: chance makes that in one of 1,024. A record whose base moves tells
// nothing: the base does work too. drive: what drives the record.
std::optional<Finding> find_negative_work(const Record& record, const Drive& drive);

}  // namespace host_sim::data_check
