// Lines of a text file, and their fields.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace host_sim {

// The fields of one line. Quotes are taken off; inside them a separator does not separate. A separator of ' ' stands for
// any run of blanks and tabs.
std::vector<std::string> split_fields(std::string_view line, char separator);

// Takes the text up to the next line end (or the end) off the front; a "\r" before the line end goes too.
std::string_view take_line(std::string_view& rest);
bool is_blank(std::string_view line);
bool is_comment(std::string_view line);  // begins with "#", "%" or "//"

}  // namespace host_sim
