// What stands in a table of numbers beside the numbers: words for no value, and text below the last row.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace host_sim {

// "", "NaN", "NA", "N/A", "null", "None", "#N/A", "-", "1.#QNAN", "-nan(ind)", in upper or lower case.
bool says_no_value(std::string_view field);

// Whether a line begins with a digit, a sign or a point, perhaps behind blanks and a quote.
bool begins_like_number(std::string_view line);

// How many of the lines are neither blank nor comments, where none begins like a number and they are few: what a program writes
// below a table. Nothing where the table goes on.
std::optional<size_t> text_below(std::string_view lines);

}  // namespace host_sim
