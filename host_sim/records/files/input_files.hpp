// The files that a command has read: no result may take their place.
#pragma once
#include <string>

namespace host_sim {

// From any thread.
void note_input_file(const std::string& path);
// Whether that path leads to one of them, under whatever name.
bool is_input_file(const std::string& path);

}  // namespace host_sim
