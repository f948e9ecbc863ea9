// Universal File Format, dataset 58 (function at a nodal DOF), the ASCII form: what modal-test systems export.
//
// One dataset is one channel; it must be a time response (function type 1, or 0), real, with an even abscissa.
//   quantity   ordinate data type 8 displacement, 11 velocity, 12 acceleration, 13 excitation force
//   DOF        response node and direction. The pairs (node, direction without its sign) that occur, sorted by node and
//              then direction, are DOF 1, 2, ... of the rig; a negative direction turns the sign of the values.
//              Directions 1 to 3 are translations, 4 to 6 rotations; 0 (scalar) is what the rig's DOF is.
//   base       a response entity named BASE is the rig's moving base
//   units      SI, or what dataset 164 in the same file says
// Other datasets are passed over.
#pragma once
#include <string>
#include <string_view>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// Extension .uff, .unv or .58, or a first line that holds -1 alone.
bool is_uff(const std::string& path, std::string_view content);

// Throws DataFileError with the line.
Record parse_uff(std::string_view content, const std::string& file, const rig_file::RigModel& model);

}  // namespace host_sim
