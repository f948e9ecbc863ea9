// A scenario's run as a result to show: estimates beside truth and the paper.
#pragma once
#include "host_sim/programs/results/estimate_result.hpp"
#include "host_sim/virtual_rig/run_scenario.hpp"

namespace host_sim {

EstimateResult result_of_run(const Scenario& scenario, const RunResult& run);

}  // namespace host_sim
