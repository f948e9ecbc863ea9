// Measured data of any supported format into a Record.
#pragma once
#include <string>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// The format follows from the file's first bytes and extension; what no other format claims is read as CSV.
// Throws DataFileError. To add a format, add a line to the table in record_reader.cpp.
Record read_record(const std::string& path, const rig_file::RigModel& model);

// The whole file. Throws DataFileError where it cannot be read.
std::string read_whole_file(const std::string& path);

}  // namespace host_sim
