// The parts of a scenario file, each with its own reader. All throw rig_file::RigFileError.
#pragma once
#include <string>

#include "hal/rig_file/toml/toml_checks.hpp"
#include "host_sim/plant/scenario/scenario.hpp"

namespace host_sim {

// A path as written in `file`: relative to that file's folder.
std::string beside(const std::string& file, const std::string& path);

// [[level]] tables; the scenario's rig and sample rate must be there already.
void read_levels(const rig_file::Place& top, const toml::table& root, Scenario& scenario);
// [sensors] and [[sensors.channel]].
void read_sensors(const rig_file::Place& top, const toml::table& root, Scenario& scenario);

}  // namespace host_sim
