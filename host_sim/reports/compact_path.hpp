// Shorter paths of the same shape.
#pragma once
#include <string>

namespace host_sim::reports {

// SVG path data of absolute M and L commands, as gnuplot writes them, as relative steps of tenths: a third of the
// length. Every point is rounded to the nearest tenth by itself, so errors do not add up. A path with other commands
// comes back as it is.
std::string compact_path(const std::string& data);

// compact_path for every d='...' of a document.
std::string with_compact_paths(const std::string& svg);

}  // namespace host_sim::reports
