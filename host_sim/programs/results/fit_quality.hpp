// How well the estimated rig reproduces the measured accelerations: the paper's normalised mean square error.
#pragma once
#include <vector>

#include "host_sim/programs/results/estimate_result.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// Fills mse_percent, mse_of and mse_note.
//
// Eq. 13 per DOF i: MSE = 100 sum_j (a_ij - a~_ij)^2 / (N s_i^2), s_i^2 the variance of the measured acceleration a,
// and a~ that of the estimated rig running freely under the measured force from the state in which the first periods of
// the record begin (fitted_start.hpp); all records together. A DOF whose acceleration is not recorded has it derived from its velocity or displacement; the
// simulated signal then takes the same way, so that both have the same band. A rig with a massless DOF does not run
// freely: there the MSE is that of the force balance f - m a - sum of link forces, over the variance of f (of m a where
// no force is recorded), and mse_of says so. The zero of an accelerometer does not count. There is none of a free decay of which
// accelerations alone are recorded: its initial state is not known.
// Returns the simulations, one a record; none where the rig does not run freely.
std::vector<Record> judge_fit(const rig_file::RigModel& model, const std::vector<Record>& records,
                              EstimateResult& result);

}  // namespace host_sim
