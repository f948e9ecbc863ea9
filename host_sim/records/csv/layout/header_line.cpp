#include "host_sim/records/csv/layout/header_line.hpp"

#include <optional>
#include <utility>

#include "host_sim/records/csv/layout/naming_comment.hpp"
#include "host_sim/records/csv/text/text_lines.hpp"

namespace host_sim {
namespace {

struct TextLine {
  size_t number = 0, before = 0;  // `before`: lines before it that are neither blank nor comments
  std::string_view text, rest;
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

// Names that mean nothing to us: the first line above the numbers that has as many fields as they, else the first of all.
Header names_above(std::vector<TextLine> above, const TextLine& numbers) {
  for (size_t i = 0; i < above.size();) {
    const auto separator = separator_of_names(above[i].text, numbers.text);
    if (!separator)
      ++i;
    else if (!is_title(above[i], *separator))
      return named_by(above[i], *separator, above[i].before);
    else
      above.erase(above.begin() + static_cast<std::ptrdiff_t>(i));
  }
  if (!above.empty()) return first_of(above);
  std::string_view next = numbers.rest;
  take_line(next);
  return {numbers.number, likely_separator(numbers.text, next), numbers.text, numbers.rest, numbers.before, true};
}

// CASSY Lab puts a word before its names: DEF="Zeit" t / s.
std::string_view without_keyword(std::string_view line) {
  constexpr std::string_view kDefines = "DEF=";
  return line.substr(0, kDefines.size()) == kDefines ? line.substr(kDefines.size()) : line;
}

// Nothing but comments spoke of channels, none of them with a name for each column.
Header names_of(const std::optional<NamingComment>& comment, const std::vector<TextLine>& above,
                const TextLine& numbers) {
  Header header = names_above(above, numbers);
  if (!comment || !header.unnamed) return header;
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
  std::optional<NamingComment> unfit;
  std::string_view rest = content;
  size_t passed_over = 0;
  for (size_t number = 1; !rest.empty() && number <= kLongestPreamble; ++number) {
    const std::string_view from_here = rest;
    std::string_view line = take_line(rest);
    if (is_blank(line)) continue;
    std::string_view below = rest;
    if (is_row_of_numbers(line)) {
      const std::string_view next = take_line(below);
      if (is_row_of_numbers(next) && same_table(line, next))  // names stand above their numbers
        return names_of(unfit, above, {number, passed_over, line, from_here});
      if (is_row_of_numbers(next)) above.clear();  // the names above were those of this one row
    }
    line = without_keyword(line);
    const bool comment = is_comment(line);
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
    if (!is_row_of_numbers(line)) above.push_back({number, passed_over, line, rest});
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
