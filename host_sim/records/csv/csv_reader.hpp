// CSV of measured data in the dialects that people have; docs/measured_data.md.
#pragma once
#include <string>
#include <string_view>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/columns/reading_options.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// Fields are separated by comma, semicolon, tab or blanks, numbers have a point or a comma; quotes, comment lines, a row
// of units, further columns, CRLF, UTF-8 and UTF-16 are understood. Blank lines only at the end.
// Throws DataFileError with the line: no channel, a ragged line, text in place of a number, an uneven step.
Record parse_csv(std::string_view content, const std::string& file, const rig_file::RigModel& model,
                 const ReadingOptions& options = {});

}  // namespace host_sim
