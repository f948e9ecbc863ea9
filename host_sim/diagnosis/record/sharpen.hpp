// Sharper motion from a first model. Smoothing rounds the kink that friction puts into a velocity, which shifts its
// reversals in time; where the sensors are weaker than their noise the model's own acceleration takes their place.
#pragma once
#include "../rows/rows.hpp"

namespace diagnosis {

// Renews smooth_x, smooth_v, smooth_a of DOFs with a mass. Terms of the model must have been prepared.
void sharpen(std::vector<FusedRecord>& records, const System& system, const std::vector<ActiveTerm>& model);

// Adds to smooth_x, smooth_v, smooth_a of DOFs without a displacement channel what is slower than the rows: the motion that
// balances the force and the model's terms. Nothing where the ground does not hold the rig in place.
void add_slow_motion(FusedRecord& record, const System& system, const std::vector<ActiveTerm>& model, size_t index);

// Force minus every term of the model, samples x DOFs; terms of mass are left out where `without_mass`.
Eigen::MatrixXd imbalance(const System& system, const FusedRecord& record, const std::vector<ActiveTerm>& model,
                          size_t index, bool without_mass);

}  // namespace diagnosis
