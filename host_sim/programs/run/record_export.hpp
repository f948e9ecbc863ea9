// The simulated measurements of a run as files that `estimate` and `diagnose` read.
#pragma once
#include <string>
#include <vector>

#include "host_sim/virtual_rig/run_scenario.hpp"

namespace host_sim {

// Writes FOLDER/rig.toml (what the estimator is told) and FOLDER/level_1.csv, level_2.csv, ... (what the sensors showed
// after settling). The folder is made where it is missing. Throws OutputError; files of an earlier run stay whole.
void export_records(const std::string& folder, const Scenario& scenario, const RunResult& run);

// Names of the files in FOLDER that such a run has written which had more levels: estimate and diagnose would take them for this
// one's with FOLDER/level_*.csv.
std::vector<std::string> levels_of_others(const std::string& folder, size_t levels);

}  // namespace host_sim
