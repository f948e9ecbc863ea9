// Whether the variables of a MAT file are as large as they say: the library beneath believes them, reads on into what follows, or
// makes room for billions of numbers that are not there.
#pragma once
#include <string>
#include <string_view>

#include "host_sim/ingestion/mat/mat_library.hpp"

namespace host_sim {

// Of version 5 (the other versions have their numbers counted once). Throws DataFileError that names the variable.
void require_sizes_of_mat(std::string_view content, const std::string& file, const MatLibrary& library);

}  // namespace host_sim
