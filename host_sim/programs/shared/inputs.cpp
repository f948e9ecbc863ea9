#include "host_sim/programs/shared/inputs.hpp"

#include "hal/rig_file/toml/rig_reader.hpp"
#include "host_sim/records/files/input_files.hpp"

namespace host_sim {

rig_file::RigModel read_rig(const std::string& path) {
  rig_file::RigModel model = rig_file::read_rig_file(path);
  note_input_file(path);
  return model;
}

Scenario read_scenario(const std::string& scenario) {
  Scenario read = load_scenario(scenario);
  note_input_file(scenario);
  return read;
}

}  // namespace host_sim
