// Coefficients and shapes that let the free-running simulation follow the record: output-error refinement of a model
// that has been fitted to the equation error.
#pragma once
#include <vector>

#include "free_run.hpp"

namespace diagnosis {

// Gauss-Newton with halved steps over the fitted values and the added shapes; stops where a step gains under 1 %. Widens
// the standard deviations by how far the values move. Returns the simulation's error, NRMSE in percent.
double tune(const System& system, std::vector<ActiveTerm>& model, const std::vector<FusedRecord>& records);

}  // namespace diagnosis
