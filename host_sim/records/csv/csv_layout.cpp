#include "host_sim/records/csv/csv_layout.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <optional>

#include "host_sim/records/columns/column_name.hpp"
#include "host_sim/records/columns/units.hpp"
#include "host_sim/records/csv/lvm_header.hpp"

namespace host_sim {
namespace {

constexpr char kSeparators[] = {'\t', ';', ',', ' '};
constexpr size_t kLongestPreamble = 200;  // lines

bool blank(char c) { return c == ' ' || c == '\t'; }

std::string_view without_comment_sign(std::string_view line) {
  const size_t first = line.find_first_not_of(" \t#%/");
  return first == std::string_view::npos ? std::string_view() : line.substr(first);
}

struct Header {
  size_t line = 0;  // 0: none
  char separator = ',';
  std::string_view text, rest;
  size_t passed_over = 0;  // lines before it that are neither blank nor comments
  bool unnamed = false;    // it is the first row of numbers: nothing stands above
  bool surplus = false;    // it has more names than there are columns
  std::string unfit = {};  // of unnamed ones: what a comment above them names, which are not as many
};

using MeansChannel = std::function<bool(const std::string&)>;

// How many fields mean a channel, and with which separator most do.
size_t score(std::string_view line, const MeansChannel& means_channel, char& separator) {
  size_t best = 0;
  for (const char candidate : kSeparators) {
    const std::vector<std::string> fields = split_fields(line, candidate);
    const auto count = static_cast<size_t>(std::count_if(fields.begin(), fields.end(), means_channel));
    if (count > best) {
      best = count;
      separator = candidate;
    }
  }
  return best;
}

// "0.004  -1,5e-3": numbers of a table, whatever separates them.
bool is_row_of_numbers(std::string_view line) {
  bool digit = false;
  for (const char c : line) {
    if (c == '\0' || std::strchr("0123456789+-.,;:/eE \t\r", c) == nullptr) return false;
    digit = digit || (c >= '0' && c <= '9');
  }
  return digit;
}

// Names above so many blank-separated numbers: of several words each, where two blanks and more part them into as many.
std::vector<std::string> split_names(std::string_view names, char separator, size_t fields) {
  std::vector<std::string> plain = split_fields(names, separator), wide;
  if (separator != ' ' || plain.size() == fields) return plain;
  for (size_t at = 0; (at = names.find_first_not_of(" \t", at)) != std::string_view::npos;) {
    const size_t end = std::min({names.find("  ", at), names.find('\t', at), names.size()});
    wide.emplace_back(names.substr(at, end - at));
    at = end;
  }
  return wide.size() == fields ? wide : plain;
}

// What separates names that mean nothing to us: with it they are as many as the fields of the next row, and most.
char likely_separator(std::string_view names, std::string_view rest) {
  std::string_view row;
  while (!rest.empty() && is_blank(row)) row = take_line(rest);
  char best = ',';
  size_t most = 1;
  for (const char candidate : kSeparators) {
    const size_t count = split_fields(names, candidate).size();
    if (count > most && split_fields(row, candidate).size() == count) most = count, best = candidate;
  }
  return best;
}

// Two rows of one table: as many fields in both, with a separator that is there; or single numbers.
bool same_table(std::string_view row, std::string_view next) {
  bool single = true;
  for (const char separator : kSeparators) {
    const size_t fields = split_fields(row, separator).size(), below = split_fields(next, separator).size();
    if (fields > 1 && fields == below) return true;
    single = single && fields <= 1 && below <= 1;
  }
  return single;
}

// With which a line has as many fields as a row of numbers; nothing where none does.
std::optional<char> separator_of_names(std::string_view names, std::string_view row) {
  std::optional<char> best;
  size_t most = 1;
  bool single = true;
  for (const char candidate : kSeparators) {
    const size_t fields = split_fields(row, candidate).size(), count = split_names(names, candidate, fields).size();
    if (count > most && fields == count) most = count, best = candidate;
    single = single && fields <= 1 && (count <= 1 || candidate == ' ');
  }
  return single ? ',' : best;
}

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

// Names that mean nothing to us: the first line above the numbers that has as many fields as they, else the first of all.
Header names_above(const std::vector<TextLine>& above, const TextLine& numbers) {
  for (const TextLine& line : above)
    if (const auto separator = separator_of_names(line.text, numbers.text))
      return named_by(line, *separator, line.before);
  if (!above.empty()) return first_of(above);
  std::string_view next = numbers.rest;
  take_line(next);
  return {numbers.number, likely_separator(numbers.text, next), numbers.text, numbers.rest, numbers.before, true};
}

// "columns: t_s, force_1_N" without the word before the names, where that hides none.
std::string_view without_title(std::string_view line, const MeansChannel& means_channel) {
  const size_t colon = line.find(':'), names = line.find_first_not_of(" \t", colon + 1);
  if (colon == std::string_view::npos || names == std::string_view::npos || names == colon + 1) return line;
  char separator = ',';
  const std::string_view behind = line.substr(names);
  return score(behind, means_channel, separator) > 0 &&
                 score(behind, means_channel, separator) >= score(line, means_channel, separator)
             ? behind
             : line;
}

// A comment that speaks of channels: names of all columns, of more than there are (from the left), or a sentence.
struct NamingComment {
  Header header;
  size_t names = 0, fields = 0;  // fields: of the first row of numbers; 0: none comes
  bool surplus = false;          // the names are more, and what is too much means no channel
  bool fits() const { return fields == 0 || names == fields; }
};

size_t fields_of(std::string_view row, char separator) {
  size_t fields = split_fields(row, separator).size();
  for (const char other : kSeparators)
    if (fields <= 1) fields = split_fields(row, other).size();
  return fields;
}

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
    const bool comment = is_comment(line);
    if (comment) line = without_title(without_comment_sign(line), means_channel);
    char separator = ',';
    if (score(line, means_channel, separator) > 0) {
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

bool has_digit_first(const std::string& field) {
  const size_t first = field.find_first_not_of(" +-.,");
  return first != std::string::npos && field[first] >= '0' && field[first] <= '9' && field != "1/min";
}

// A row's title that says that units follow.
bool says_units(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text.find("unit") != std::string::npos;
}

// The columns' units, where the fields from `first` on are units or blank, and no number. Behind a title that says so a word that is no
// known unit is one all the same: whose column it is is told, and the others keep theirs.
bool read_units(const std::vector<std::string>& fields, size_t first, CsvLayout& layout) {
  bool any = false;
  const bool titled = first > 0 && !fields.empty() && says_units(fields[0]);
  for (size_t i = first; i < fields.size(); ++i) {
    const std::string text = trimmed_text(fields[i]);
    if (text.empty() || text == "-" || text == "Unit" || text == "Units") continue;  // a row's title is no unit
    if (has_digit_first(text) || (first > 0 && !titled && !find_unit(text))) return false;
    any = any || find_unit(text).has_value();
  }
  if (!any || fields.size() > layout.columns.size() + 1) return false;
  for (size_t i = first; i < std::min(fields.size(), layout.columns.size()); ++i) {
    const HeadParts parts = split_head(fields[i]);
    layout.columns[i].unit = parts.unit.empty() ? parts.name : parts.unit;  // "(mm)" or "mm"
  }
  return true;
}

// Takes a row of units off the front of the data.
bool take_units(CsvLayout& layout) {
  std::string_view rest = layout.data;
  if (!read_units(split_fields(take_line(rest), layout.separator), 0, layout)) return false;
  layout.data = rest;
  ++layout.data_line;
  return true;
}

// A row of units above the names, behind a word of its own as LabVIEW's Y_Unit_Label.
void find_units_above(std::string_view content, CsvLayout& layout) {
  for (size_t number = 1; number < layout.header_line; ++number)
    if (read_units(split_fields(take_line(content), layout.separator), 1, layout)) return;
}

void skip_blank_and_comment_lines(CsvLayout& layout) {
  for (std::string_view rest = layout.data; !rest.empty();) {
    const std::string_view line = take_line(rest);
    if (!is_comment(line) && !(is_blank(line) && !is_blank(rest))) return;
    if (is_blank(line) && rest.find_first_not_of(" \t\r\n") == std::string_view::npos) return;
    layout.data = rest;
    ++layout.data_line;
  }
}

// "-----+-----" or "=====": what is drawn below the names.
bool is_ruled(std::string_view line) {
  return (line.find("---") != std::string_view::npos || line.find("===") != std::string_view::npos) &&
         line.find_first_not_of("-=+|: \t\r,;") == std::string_view::npos;
}

bool commas_are_points(const CsvLayout& layout) {
  if (layout.separator == ',') return false;
  constexpr int kRowsLookedAt = 100;
  std::string_view rest = layout.data;
  bool comma = false;
  for (int i = 0; i < kRowsLookedAt && !rest.empty(); ++i) {
    const std::string_view line = take_line(rest);
    if (is_comment(line)) continue;
    for (const std::string& field : split_fields(line, layout.separator)) {
      if (!has_digit_first(field)) continue;
      if (field.find_first_of(":") != std::string::npos) continue;  // a clock
      if (field.find('.') != std::string::npos) return false;
      comma = comma || field.find(',') != std::string::npos;
    }
  }
  return comma;
}

}  // namespace

std::vector<std::string> split_fields(std::string_view line, char separator) {
  std::vector<std::string> fields;
  std::string field;
  bool inside = false, any = false;
  if (separator == ' ')
    while (!line.empty() && blank(line.front())) line.remove_prefix(1);
  for (size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"') {
      inside = !inside;
      any = true;
    } else if (!inside && (separator == ' ' ? blank(c) : c == separator)) {
      if (separator == ' ' && field.empty() && !any) continue;
      fields.push_back(field);
      field.clear();
      any = false;
    } else {
      field += c;
    }
  }
  if (separator != ' ' || !field.empty() || any) fields.push_back(field);
  return fields;
}

std::string_view take_line(std::string_view& rest) {
  const size_t end = rest.find('\n');
  std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t\r") == std::string_view::npos; }

bool is_comment(std::string_view line) {
  const size_t first = line.find_first_not_of(" \t\"");
  if (first == std::string_view::npos) return false;
  if (std::strchr("-=+|", line[first]) != nullptr) return is_ruled(line);
  return line[first] == '#' || line[first] == '%' || line.substr(first, 2) == "//";
}

namespace {

// The first row of numbers; empty where it does not come soon.
std::string_view first_row(std::string_view content) {
  constexpr int kLines = 10;
  for (int i = 0; i < kLines && !content.empty(); ++i)
    if (const std::string_view line = take_line(content); is_row_of_numbers(line)) return line;
  return {};
}

// The names stand behind the headers of LabVIEW's files, in which "Time" is no column.
Header header_below(const LvmHeader& lvm) {
  Header header{lvm.lines, lvm.separator, "", lvm.below, lvm.lines};
  while (!header.rest.empty() && is_blank(header.text)) header.text = take_line(header.rest), ++header.line;
  return header;
}

}  // namespace

CsvLayout find_layout(std::string_view content, const std::function<bool(const std::string&)>& means_channel) {
  const LvmHeader lvm = lvm_header_of(content);
  const Header header = lvm.lines > 0 ? header_below(lvm) : find_header(content, means_channel);
  CsvLayout layout;
  layout.separator = header.separator;
  layout.header_line = header.line;
  layout.data = header.rest;
  layout.data_line = header.line + (header.unnamed ? 0 : 1);
  layout.unnamed = header.unnamed;
  layout.unfit = header.unfit;
  const size_t fields = split_fields(first_row(header.rest), header.separator).size();
  for (const std::string& field : split_names(header.text, header.separator, fields))
    layout.columns.push_back({header.unnamed ? std::to_string(layout.columns.size() + 1) : field, ""});
  if (header.surplus)
    layout.notes.push_back("line " + std::to_string(header.line) + " names " + std::to_string(layout.columns.size()) +
                           " columns, the rows have " + std::to_string(fields) + ": named from the left");
  if (header.passed_over > 0)
    layout.notes.push_back("passed over: " + std::to_string(header.passed_over) + " line" +
                           (header.passed_over == 1 ? "" : "s") + " before the " +
                           (header.unnamed ? "numbers" : "names") + " of line " + std::to_string(header.line));
  if (!lvm.has_times) layout.step_s = lvm.step_s;
  skip_blank_and_comment_lines(layout);
  if (!layout.unnamed && take_units(layout))
    skip_blank_and_comment_lines(layout);
  else
    find_units_above(content, layout);
  layout.decimal_comma = commas_are_points(layout);
  return layout;
}

}  // namespace host_sim
