// Universal File Format, dataset 58 (function at a nodal DOF), ASCII and binary (58b): what modal-test systems export.
//
// One dataset is one channel: a time response (function type 1, or 0), real, with an even abscissa. A channel that comes
// for the n-th time is of the n-th record. Functions of other types and ordinates of other quantities are ignored with a note.
//   quantity   ordinate data type 8 displacement, 11 velocity, 12 acceleration, 13 excitation force
//   DOF        response node and direction. The pairs (node, direction without its sign) that occur, sorted by node and
//              then direction, are DOF 1, 2, ... of the rig; a negative direction turns the sign of the values.
//              Directions 1 to 3 are translations, 4 to 6 rotations; 0 (scalar) is what the rig's DOF is.
//   base       a response entity named BASE is the rig's moving base
//   units      the ordinate's label ("g", "mm"), else what dataset 164 in the same file says, else SI
// Other datasets are passed over.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/columns/reading_options.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// Extension .uff, .unv or .58, or a first line that holds -1 alone.
bool is_uff(const std::string& path, std::string_view content);

// Throws DataFileError with the line.
std::vector<Record> parse_uff(std::string_view content, const std::string& file, const rig_file::RigModel& model,
                              const ReadingOptions& options = {});

}  // namespace host_sim
