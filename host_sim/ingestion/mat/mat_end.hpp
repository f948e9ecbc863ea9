// Whether a MAT file is all there: its elements tell how long they are, and the library beneath fills what is missing with noughts.
#pragma once
#include <cstdint>
#include <string>

namespace host_sim {

// Bytes that the elements of a file of version 4 or 5 reach beyond its end; 0: none, or another version (HDF5 tells by itself).
// Formats: "MAT-File Format", The MathWorks.
uint64_t missing_mat_bytes(const std::string& path);

}  // namespace host_sim
