#include "host_sim/records/csv/layout/comment_words.hpp"

#include <algorithm>
#include <optional>

#include "host_sim/records/columns/column.hpp"
#include "host_sim/records/csv/layout/naming_comment.hpp"
#include "host_sim/records/csv/layout/separators.hpp"
#include "host_sim/records/csv/text/text_lines.hpp"

namespace host_sim {
namespace {

std::vector<Column> words_for_each(std::string_view comment, std::string_view row) {
  const std::string_view line = without_comment_sign(comment);
  const size_t colon = line.find(':');
  const std::string_view behind = colon == std::string_view::npos ? std::string_view() : line.substr(colon + 1);
  for (std::string_view names : {line, behind}) {
    while (!names.empty() && names.front() == ' ') names.remove_prefix(1);
    const auto separator = names.empty() ? std::nullopt : separator_of_names(names, row);
    if (!separator) continue;
    std::vector<Column> words;
    for (const std::string& word : split_fields(names, *separator)) words.push_back({trimmed_text(word), ""});
    const auto is_none = [](const Column& word) { return word.head.empty() || is_row_of_numbers(word.head); };
    if (words.size() > 1 && std::none_of(words.begin(), words.end(), is_none)) return words;
  }
  return {};
}

}  // namespace

std::string words_for_columns(const std::vector<CommentLine>& comments, std::string_view row) {
  for (size_t i = comments.size(); i-- > 0;) {
    const std::vector<Column> words = words_for_each(comments[i].text, row);
    if (!words.empty())
      return "the comment of line " + std::to_string(comments[i].number) +
             " has a word for each: " + quoted_heads(words) +
             "; where these are names, --column takes them, as in --column t=" + quoted_head(words.front());
  }
  return "";
}

}  // namespace host_sim
