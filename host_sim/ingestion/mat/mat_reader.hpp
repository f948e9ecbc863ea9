// MAT files (MATLAB, Octave, SciPy; all versions that libmatio reads).
//
// Variables are named as the columns of a CSV file: real vectors of one length, "force_1_N", "displacement_1_mm", ...,
// beside either t_s (constant step) or sample_rate_Hz (a scalar, also "fs"; the record then starts at 0). They stand at
// the top or are the fields of a struct; each struct, and each element of an array of structs, is a record. Other
// vectors are ignored with a note, text and other scalars are passed over.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/columns/reading_options.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// Extension .mat, or the first bytes of a MAT file.
bool is_mat(const std::string& path, std::string_view content);

// Throws DataFileError that names the variable.
std::vector<Record> read_mat(const std::string& path, const rig_file::RigModel& model,
                             const ReadingOptions& options = {});

}  // namespace host_sim
