#include "host_sim/records/csv/layout/naming_comment.hpp"

#include <algorithm>

#include "host_sim/records/csv/text/text_lines.hpp"

namespace host_sim {
namespace {

// "columns: t_s, force_1_N" without the word before the names, where that hides none.
std::string_view without_title(std::string_view line, const MeansChannel& means_channel) {
  const size_t colon = line.find(':'), names = line.find_first_not_of(" \t", colon + 1);
  if (colon == std::string_view::npos || names == std::string_view::npos || names == colon + 1) return line;
  char separator = ',';
  const std::string_view behind = line.substr(names);
  return channel_fields(behind, means_channel, separator) > 0 &&
                 channel_fields(behind, means_channel, separator) >= channel_fields(line, means_channel, separator)
             ? behind
             : line;
}

}  // namespace

NamingComment naming_comment(const Header& header, const MeansChannel& means_channel) {
  NamingComment comment;
  comment.header = header;
  std::string_view rest = header.rest, row;
  for (size_t i = 0; i < kLongestPreamble && !rest.empty() && row.empty(); ++i)
    if (const std::string_view line = take_line(rest); is_row_of_numbers(line)) row = line;
  if (!row.empty()) comment.fields = fields_of(row, header.separator);
  const std::vector<std::string> names = split_names(header.text, header.separator, comment.fields);
  comment.names = names.size();
  if (comment.names <= comment.fields) return comment;
  const auto end = names.begin() + static_cast<std::ptrdiff_t>(comment.fields);
  const bool sentence = header.separator == ' ' && !std::all_of(names.begin(), end, means_channel);
  comment.surplus = !sentence && std::none_of(end, names.end(), means_channel);
  return comment;
}

std::string_view without_comment_sign(std::string_view line) {
  const size_t first = line.find_first_not_of(" \t#%/");
  return first == std::string_view::npos ? std::string_view() : line.substr(first);
}

std::string_view text_of_comment(std::string_view line, const MeansChannel& means_channel) {
  return without_title(without_comment_sign(line), means_channel);
}

}  // namespace host_sim
