// Free-running simulation of a fitted model under the measured force, from the measured state at one instant.
#pragma once
#include <vector>

#include "model_fit.hpp"

namespace diagnosis {

struct FreeRun {
  std::vector<Series> x, v, a;  // per DOF, samples from .. to - 1
  bool finite = true;           // false: the model runs away
};

// Fixed steps of an eighth of a sample; friction by impulses that stop a link or slide it at its level.
// DOFs without mass have no motion of their own: they follow the record.
FreeRun free_run(const System& system, const std::vector<ActiveTerm>& model, const FusedRecord& record,
                 Eigen::Index from, Eigen::Index to);

struct HoldoutScore {
  std::vector<double> nrmse_percent, mse_percent;  // per DOF
};
// Displacement NRMSE and acceleration MSE (Eq. 13) of a free run against the fused record. For a DOF without mass both
// are of the force that the model gives under the measured motion.
HoldoutScore score_free_run(const System& system, const std::vector<ActiveTerm>& model, const FusedRecord& record,
                            Eigen::Index from, Eigen::Index to);

}  // namespace diagnosis
