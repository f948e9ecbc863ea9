// What a user would do instead: a least-squares fit of the sampled equations of motion (the paper's reference 11),
//   sum_k p_k * (force of unknown k per unit) = f - m a - k u,  one row per DOF and sample, all weighted alike.
#pragma once
#include <vector>

#include "host_sim/plant/scenario/scenario.hpp"
#include "host_sim/records/record.hpp"

namespace accuracy {

// Masses and stiffnesses are known, viscous and Coulomb coefficients unknown where the rig says so; all of force,
// displacement, velocity and acceleration are in the records. Result in the order of the core's unknowns.
std::vector<double> direct_fit(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& records);

}  // namespace accuracy
