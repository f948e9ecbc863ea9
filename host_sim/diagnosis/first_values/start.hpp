// The rig file's own terms, with first values for what it leaves open.
#pragma once
#include "../simulate/model.hpp"

namespace diagnosis::runs {

// Throws CannotAnswer where nothing sets the scale: no known coefficient and no force.
Model rig_as_given(const System& system, const std::vector<Prepared>& records);
// First values by least squares over the guessed motion: the balance of forces of every DOF, each weighted by its own
// size.
void start_values(const System& system, const std::vector<Prepared>& records, Model& model);

}  // namespace diagnosis::runs
