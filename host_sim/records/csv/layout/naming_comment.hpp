// A comment that speaks of channels: names of all columns, of more than there are (from the left), or a sentence.
#pragma once
#include <string_view>

#include "host_sim/records/csv/layout/header_line.hpp"

namespace host_sim {

constexpr size_t kLongestPreamble = 200;  // lines

struct NamingComment {
  Header header;
  size_t names = 0, fields = 0;  // fields: of the first row of numbers; 0: none comes
  bool surplus = false;          // the names are more, and what is too much means no channel
  bool fits() const { return fields == 0 || names == fields; }
};

// Of the comment whose text is the header's.
NamingComment naming_comment(const Header& header, const MeansChannel& means_channel);

std::string_view without_comment_sign(std::string_view line);

// What a comment line says: without its sign, and without a word before the names ("columns: t_s, force_1_N") where that hides none.
std::string_view text_of_comment(std::string_view line, const MeansChannel& means_channel);

}  // namespace host_sim
