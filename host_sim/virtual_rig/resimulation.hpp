// Eq. 13: does the rig with the estimates move as the simulated rig did?
#pragma once
#include "host_sim/virtual_rig/run_scenario.hpp"

namespace host_sim {

// Fills resimulated, mse_percent and mse_note from result.parameters and result.measured (truth, excitation).
void judge_by_resimulation(const Scenario& scenario, RunResult& result);

}  // namespace host_sim
