// The smallest strength of each effect that these records would have shown.
#pragma once
#include <vector>

#include "../diagnosis.hpp"
#include "../search/candidates.hpp"

namespace diagnosis {

// For a fitted model and its rows: one limit per effect and place. The strength is the coefficient (backlash: the gap,
// presliding_hysteresis: the presliding length) that passes the threshold in 95 of 100 such records.
std::vector<DetectionLimit> detection_limits(Rows& rows, const CandidateBank& bank,
                                             const std::vector<ActiveTerm>& model, const Fit& fit);

// damping: of each of the rig file's links, the rms force of its dampers. Of such a link its own; of a DOF, or of a link that
// the rig file lacks, the largest nearby.
double damping_at(const System& system, const std::vector<double>& damping, const Term& place);

}  // namespace diagnosis
