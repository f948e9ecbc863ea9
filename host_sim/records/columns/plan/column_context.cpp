#include "host_sim/records/columns/plan/column_context.hpp"

#include "hal/rig_file/channel_name.hpp"
#include "host_sim/records/columns/quoted.hpp"
#include "host_sim/records/files/data_file_error.hpp"

namespace host_sim {

void ColumnContext::refuse(const std::string& problem) const { throw DataFileError(file, line, problem); }

void ColumnContext::require_channel(const std::string& name) const {
  const bool no_rig = model.dofs.empty();
  const std::string fault =
      no_rig && rig_file::parse_channel_name(name) ? "" : rig_file::channel_name_fault(name, model);
  if (!fault.empty()) refuse("channel " + quoted(name) + ": " + fault);
}

}  // namespace host_sim
