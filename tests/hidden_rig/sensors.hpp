// From motion to records: faults, anti-alias filter, noise, rounding.
#pragma once
#include "dice.hpp"
#include "draw.hpp"

namespace hidden_rig {

constexpr size_t kLeadIn = 300;  // samples before a record that the anti-alias filter settles on

// What the sensors of one record deliver, from motion and drive that begin `lead_in` samples before it. Faults of the
// measurement among the true rig's effects are applied.
host_sim::Record measure(Dice& dice, const Condition& condition, const std::vector<std::string>& sensors_of_dof,
                         const TrueRig& rig, const Motion& motion, const Drive& drive, size_t drive_skip,
                         size_t lead_in);

// Chooses channel and size of a fault of the measurement.
TrueEffect draw_fault(Dice& dice, const std::string& kind, const std::vector<std::string>& channels, double period_s);

}  // namespace hidden_rig
