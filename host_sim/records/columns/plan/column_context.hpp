// What the columns of a file are read with, and where a fault in them is said.
#pragma once
#include <string>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/columns/reading_options.hpp"

namespace host_sim {

struct ColumnContext {
  const rig_file::RigModel& model;
  const ReadingOptions& options;
  const std::string& file;
  size_t line;  // of the heads

  [[noreturn]] void refuse(const std::string& problem) const;  // throws DataFileError
  // Refuses a name that the rig has no use for. A rig without DOFs knows no channel: then the name alone decides.
  void require_channel(const std::string& name) const;
};

}  // namespace host_sim
