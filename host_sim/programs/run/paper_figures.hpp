// The paper's own results for its scenarios, to stand beside ours.
#pragma once
#include "host_sim/programs/results/estimate_result.hpp"

namespace host_sim {

// Fills `paper` of the parameters, paper_residual and paper_mse_percent where the paper gives figures for the scenario.
void add_paper_figures(const std::string& scenario_name, EstimateResult& result);

}  // namespace host_sim
