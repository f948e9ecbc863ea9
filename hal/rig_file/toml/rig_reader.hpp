// Reads a rig file (schema rig/1, docs/formats.md). Any fault is a RigFileError that names file, line, key and
// expectation.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "hal/rig_file/rig_file_error.hpp"
#include "hal/rig_file/rig_model.hpp"

namespace rig_file {

// Files that hold a rig among other things (the board's configuration) say here what else they may hold.
struct ReadOptions {
  std::vector<std::string> other_top_level_keys;
  std::vector<std::string> other_channel_keys;
};

RigModel read_rig_file(const std::string& path, const ReadOptions& options = {});
RigModel parse_rig(std::string_view toml_text, const std::string& file, const ReadOptions& options = {});

// Refuses a rig without any "estimate".
void require_unknowns(const RigModel& model);

}  // namespace rig_file
