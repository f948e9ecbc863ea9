// Channels against the masses and springs that the rig file knows: signs and units that no channel of the same DOF tells.
//
// The equation of motion of each DOF is averaged with a bell (six boxes of h samples, one after the other) and
// differentiated with it as often as its channels ask for: a DOF with an acceleration alone has its equation twice
// differentiated, so nothing is ever integrated. Differences and box means of samples do it, and hold for all terms
// alike. What viscous and Coulomb friction and unknown coefficients explain is taken off both sides by least squares.
#pragma once
#include <vector>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// Each channel in turn is supposed to be turned over, or in a usual unit. It is named where, with that one change, less
// than a quarter of what was unexplained is left (in the mean square), where less than half of the motion's part was
// explained before, and where no other channel's change does half as well. The force in another unit and all motion in
// the inverse one are one and the same: both are said. Rigs without known mass and spring, and records in which mass and
// spring force go together (a single tone), cannot tell: nothing is found. Where no change of one channel helps, the
// channels of two DOFs are supposed to be exchanged, forces to act on other DOFs, or both, with the same limits (exchanged_dofs.hpp).
std::vector<Finding> check_rig_balance(const Record& record, const rig_file::RigModel& model);

}  // namespace host_sim::data_check
