// Text of a file as it is quoted to the user.
#pragma once
#include <string>
#include <string_view>

namespace host_sim {

// The first 40 characters, and none that would not print.
std::string quoted(std::string_view text);

}  // namespace host_sim
