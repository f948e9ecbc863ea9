// The estimates as a table for people.
#pragma once
#include <string>

#include "host_sim/programs/results/estimate_result.hpp"

namespace host_sim {

// One line per parameter: name, truth and the paper's figure where known, estimate, 95 % interval, unit, status; then
// the residual, the condition number and the MSE of Eq. 13. Numbers carry the digits that their interval supports.
// On `width` columns: sentences are wrapped, and the paper's figures and the truth go where they find no room; 0: all
// of it, as wide as it is.
std::string format_table(const EstimateResult& result, bool colours, int width = 0);

}  // namespace host_sim
