// Rows of numbers as matrices are written for programs that compute: "[ 0 1.5;" to "3 2.5]".
#pragma once
#include <string>
#include <string_view>

namespace host_sim {

// The text without semicolons that only end its rows, and without brackets around the rows: neither separates values.
// Lines stay where they are. The text itself where it has none such, else a part of `buffer`.
std::string_view without_row_ends(std::string_view content, std::string& buffer);

}  // namespace host_sim
