// Text files as other programs leave them, as UTF-8 with "\n" or "\r\n" line ends.
#pragma once
#include <string>
#include <string_view>

namespace host_sim {

// UTF-16 in either byte order, with or without a byte-order mark, becomes UTF-8; line ends of a single "\r" become
// "\n"; a byte-order mark of UTF-8 is passed over. The result is a part of `content`, or of `buffer` where bytes had to
// change.
std::string_view as_utf8(std::string_view content, std::string& buffer);

// Files of other programs that people take for tables of text, by how they begin; nullptr: none of these.
const char* other_format(std::string_view content);

}  // namespace host_sim
