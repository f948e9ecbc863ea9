// Free-running simulation of a fitted model under the measured force, from the measured state at one instant.
#pragma once
#include <vector>

#include "../rows/model_fit.hpp"

namespace diagnosis {

struct FreeRun {
  std::vector<Series> x, v, a;  // per DOF, samples from .. to - 1
  bool finite = true;           // false: the model runs away
};

// Fixed steps, `steps` to a sample; friction by impulses that stop a link or slide it at its level.
FreeRun free_run(const System& system, const std::vector<ActiveTerm>& model, const FusedRecord& record,
                 Eigen::Index from, Eigen::Index to, int steps = 8);

struct HoldoutScore {
  std::vector<double> nrmse_percent, mse_percent, velocity_percent;  // per DOF
};

// Displacement errors alone, each DOF over the deviation of its displacement, one after the other; empty where the run
// does not stay finite.
Series run_errors(const System& system, const std::vector<ActiveTerm>& model, const FusedRecord& record,
                  Eigen::Index from, Eigen::Index to, int steps);

// Displacement and velocity NRMSE and acceleration MSE (Eq. 13) of a free run against the fused record; a displacement that
// is integrated counts, frequency by frequency, as far as it is to be trusted. Where no spring of the rig file holds a DOF
// in its place the run starts again from the measured state every second. With a DOF that has no mass all are of the force
// that the model gives under the measured motion.
HoldoutScore score_free_run(const System& system, const std::vector<ActiveTerm>& model, const FusedRecord& record,
                            Eigen::Index from, Eigen::Index to);

}  // namespace diagnosis
