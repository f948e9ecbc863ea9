#include "host_sim/records/csv/layout/header_line.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "host_sim/records/columns/names/column_name.hpp"
#include "host_sim/records/columns/units/units.hpp"
#include "host_sim/records/csv/layout/comment_words.hpp"
#include "host_sim/records/csv/layout/naming_comment.hpp"
#include "host_sim/records/csv/text/text_lines.hpp"

namespace host_sim {
namespace {

struct TextLine {
  size_t number = 0, before = 0;  // `before`: lines before it that are neither blank nor comments
  std::string_view text, rest;
  size_t block = 0;  // how many blank lines stand before it
};

Header named_by(const TextLine& line, char separator, size_t passed_over) {
  return {line.number, separator, line.text, line.rest, passed_over};
}

Header first_of(const std::vector<TextLine>& lines) {
  if (lines.empty()) return {};
  return named_by(lines.front(), likely_separator(lines.front().text, lines.front().rest), 0);
}

// Words with a blank line below them, where blanks alone part them: a title that happens to have as many words as there are columns.
bool is_title(const TextLine& line, char separator) {
  std::string_view below = line.rest;
  return separator == ' ' && is_blank(take_line(below));
}

// "Record Length,2500,points,-0.005,0.12" above ",,,-0.004,0.12": an oscilloscope's settings stand beside its first rows, where the
// later ones are blank.
bool stands_beside(const TextLine& line, const TextLine& numbers) {
  const auto separator = separator_of_names(line.text, numbers.text);
  if (!separator || *separator == ' ') return false;
  const std::vector<std::string> fields = split_fields(line.text, *separator),
                                 row = split_fields(numbers.text, *separator);
  for (size_t i = 0; i < row.size(); ++i)
    if (!is_blank(row[i]) && !is_row_of_numbers(fields[i])) return false;
  return true;
}

Header unnamed_from(const TextLine& row) {
  const auto length = static_cast<size_t>(row.rest.data() + row.rest.size() - row.text.data());
  return {row.number, likely_separator(row.text, row.rest), row.text, {row.text.data(), length}, row.before, true};
}

bool are_units(const std::string& line, char separator) {
  const std::vector<std::string> fields = split_fields(line, separator);
  return std::all_of(fields.begin(), fields.end(),
                     [](const std::string& field) { return is_blank(field) || find_unit(trimmed_text(field)); });
}

// Names that mean nothing to us: above the numbers the first line that has as many fields as they, in the last block of such lines, as a
// preamble ends with a blank line; else the first line of all.
Header names_above(std::vector<TextLine> above, const TextLine& numbers) {
  std::optional<Header> names;
  size_t block = 0;
  for (size_t i = 0; i < above.size();) {
    const TextLine& line = above[i];
    const auto separator = separator_of_names(line.text, numbers.text);
    if (separator && is_title(line, *separator)) {
      above.erase(above.begin() + static_cast<std::ptrdiff_t>(i));
      continue;
    }
    ++i;
    if (!separator) continue;
    if (stands_beside(line, numbers)) return unnamed_from(line);
    if (names && (line.block == block || are_units(std::string(line.text), *separator))) continue;
    names = named_by(line, *separator, line.before);
    block = line.block;
  }
  if (names) return *names;
  return above.empty() ? unnamed_from(numbers) : first_of(above);
}

// CASSY Lab puts a word before its names: DEF="Zeit" t / s.
std::string_view without_keyword(std::string_view line) {
  constexpr std::string_view kDefines = "DEF=";
  return line.substr(0, kDefines.size()) == kDefines ? line.substr(kDefines.size()) : line;
}

// Nothing but comments spoke of channels, none of them with a name for each column.
Header names_of(const std::optional<NamingComment>& comment, const std::vector<TextLine>& above,
                const std::vector<CommentLine>& comments, const TextLine& numbers) {
  Header header = names_above(above, numbers);
  if (!header.unnamed) return header;
  header.unfit = words_for_columns(comments, numbers.text);
  if (!comment) return header;
  if (comment->surplus) {
    header = comment->header;
    header.surplus = true;
    return header;
  }
  header.unfit = "the comment of line " + std::to_string(comment->header.line) + " has " +
                 std::to_string(comment->names) + " words for " + std::to_string(comment->fields) + " columns";
  return header;
}

}  // namespace

Header find_header(std::string_view content, const MeansChannel& means_channel) {
  std::vector<TextLine> above;
  std::vector<CommentLine> comments;
  std::optional<NamingComment> unfit;
  std::string_view rest = content;
  size_t passed_over = 0, blanks = 0;
  for (size_t number = 1; !rest.empty() && number <= kLongestPreamble; ++number) {
    std::string_view line = take_line(rest);
    if (is_blank(line)) {
      ++blanks;
      continue;
    }
    std::string_view below = rest;
    if (is_row_of_numbers(line)) {
      const std::string_view next = take_line(below);
      if (is_row_of_numbers(next) && same_table(line, next))  // names stand above their numbers
        return names_of(unfit, above, comments, {number, passed_over, line, rest, blanks});
      if (is_row_of_numbers(next)) above.clear();  // the names above were those of this one row
    }
    line = without_keyword(line);
    const bool comment = is_comment(line);
    if (comment) comments.push_back({number, line});
    if (comment) line = text_of_comment(line, means_channel);
    char separator = ',';
    if (channel_fields(line, means_channel, separator) > 0) {
      const Header header{number, separator, line, rest, passed_over};
      if (!comment) return header;
      NamingComment naming = naming_comment(header, means_channel);
      if (naming.fits()) return header;
      if (!unfit) unfit = std::move(naming);
    }
    if (comment) continue;
    if (!is_row_of_numbers(line)) above.push_back({number, passed_over, line, rest, blanks});
    ++passed_over;
  }
  return first_of(above);
}

Header header_below(const LvmHeader& lvm) {
  Header header{lvm.lines, lvm.separator, "", lvm.below, lvm.lines};
  while (!header.rest.empty() && is_blank(header.text)) header.text = take_line(header.rest), ++header.line;
  return header;
}

}  // namespace host_sim
