// For files that hold a rig among other things: reads the rig out of an already parsed table.
#pragma once
#include <toml++/toml.h>

#include <string>

#include "hal/rig_file/toml/rig_reader.hpp"

namespace rig_file {

RigModel rig_from_toml(const toml::table& root, const std::string& file, const ReadOptions& options = {});

}  // namespace rig_file
