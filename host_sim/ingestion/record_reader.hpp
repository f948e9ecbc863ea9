// Measured data of any supported format into a Record.
#pragma once
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/columns/reading_options.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// The format follows from the file's first bytes and extension; what no other format claims is read as CSV. A file of
// several records (Universal File, MAT) gives them all, in its order.
// Throws DataFileError. A rig without DOFs stands for "no rig file": then every channel name is taken.
// To add a format, add a line to the table in record_reader.cpp.
std::vector<Record> read_records(const std::string& path, const rig_file::RigModel& model,
                                 const ReadingOptions& options = {});

// Of a file that holds one; throws DataFileError where it holds more.
Record read_record(const std::string& path, const rig_file::RigModel& model, const ReadingOptions& options = {});

}  // namespace host_sim
