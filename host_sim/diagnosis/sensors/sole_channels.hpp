// Faults of a channel that is the only one of its DOF's motion. No second channel bears them out: only the rig's equations,
// which the faulty motion does not fulfil, show them.
#pragma once
#include "../rows/model_fit.hpp"
#include "sensor_check.hpp"

namespace diagnosis {

bool has_sole_channel(const FusedRecord& record);  // one of its DOFs

// Beside a fitted model, the one that explains most first. Faults that the model's free coefficients can make are not listed.
std::vector<SensorFault> sole_channel_faults(const Rows& rows, const std::vector<ActiveTerm>& model, const Fit& fit);

}  // namespace diagnosis
