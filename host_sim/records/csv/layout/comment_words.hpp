// Comments above numbers that have no names of their own: words that may be the columns' names.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace host_sim {

struct CommentLine {
  size_t number = 0;
  std::string_view text;
};

// What to say of the last comment that has a word for each field of the row of numbers, none of them a number, with or without a word
// before them ("Columns: t y u"): none means a channel, but the user knows what they mean. Empty where no comment has.
std::string words_for_columns(const std::vector<CommentLine>& comments, std::string_view row);

}  // namespace host_sim
