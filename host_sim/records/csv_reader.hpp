// CSV of measured data: the first line names the columns (t_s first), then numbers; docs/formats.md.
#pragma once
#include <string>
#include <string_view>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// Lines may end in LF or CRLF; a byte-order mark and blanks around fields are passed over, blank lines only at the end.
// Throws DataFileError with the line: an unknown column, a ragged line, text in place of a number, an uneven step.
Record parse_csv(std::string_view content, const std::string& file, const rig_file::RigModel& model);

}  // namespace host_sim
