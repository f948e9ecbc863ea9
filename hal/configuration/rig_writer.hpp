// Writes a rig file that the reader reads back to the same model.
#pragma once
#include <string>

#include "hal/configuration/rig_model.hpp"

namespace rig_file {

std::string format_rig(const RigModel& model);
// Written to a temporary name, then renamed. Throws RigFileError where the file cannot be written.
void write_rig_file(const RigModel& model, const std::string& path);

}  // namespace rig_file
