// The rig files and scenarios that commands read: no result may take their place.
#pragma once
#include <string>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/plant/scenario/scenario.hpp"

namespace host_sim {

// Throws rig_file::RigFileError.
rig_file::RigModel read_rig(const std::string& path);
// A shipped scenario's name or a path. Throws as load_scenario().
Scenario read_scenario(const std::string& scenario);

}  // namespace host_sim
