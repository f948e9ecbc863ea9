// The simulated measurements of a run as files that `estimate` and `diagnose` read.
#pragma once
#include <string>

#include "host_sim/virtual_rig/run_scenario.hpp"

namespace host_sim {

// Writes FOLDER/rig.toml (what the estimator is told) and FOLDER/level_1.csv, level_2.csv, ... (what the sensors showed
// after settling). The folder is made where it is missing. Throws OutputError; files of an earlier run stay whole.
void export_records(const std::string& folder, const Scenario& scenario, const RunResult& run);

}  // namespace host_sim
