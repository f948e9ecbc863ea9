// Writes a rig file that the reader reads back to the same model.
#pragma once
#include <string>

#include "hal/rig_file/rig_model.hpp"

namespace rig_file {

std::string format_rig(const RigModel& model);

}  // namespace rig_file
