// The number that a text starts with, as std::from_chars reads it and bit by bit the same, in less time where it has at most 19
// digits as those of recordings do.
#pragma once
#include <charconv>

namespace host_sim {

// first, last: the text, without a leading plus sign. Sets value where ec is std::errc(); ptr is behind the number.
std::from_chars_result read_decimal(const char* first, const char* last, double& value);

}  // namespace host_sim
