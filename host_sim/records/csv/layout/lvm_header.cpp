#include "host_sim/records/csv/layout/lvm_header.hpp"

#include <algorithm>
#include <string>

#include "host_sim/records/columns/names/column_name.hpp"
#include "host_sim/records/csv/text/decimal_number.hpp"
#include "host_sim/records/csv/text/text_lines.hpp"

namespace host_sim {
namespace {

constexpr std::string_view kBegins = "LabVIEW Measurement", kEnd = "***End_of_Header***";
constexpr size_t kLongest = 200;  // lines

// "Delta_X\t0.001\t0.001": the keyword and what it says.
std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields;
  for (const char separator : {'\t', ','}) {
    fields = split_fields(line, separator);
    if (fields.size() > 1) break;
  }
  for (std::string& field : fields) field = trimmed_text(field);
  while (!fields.empty() && fields.back().empty()) fields.pop_back();
  return fields;
}

// The one step of all channels; 0 where they differ.
double step_of(const std::vector<std::string>& fields) {
  double step_s = 0.0;
  for (size_t i = 1; i < fields.size(); ++i) {
    std::string number = fields[i];
    std::replace(number.begin(), number.end(), ',', '.');
    double value = 0.0;
    if (read_decimal(number.data(), number.data() + number.size(), value).ec != std::errc()) return 0.0;
    if (i > 1 && value != step_s) return 0.0;
    step_s = value;
  }
  return step_s;
}

}  // namespace

LvmHeader lvm_header_of(std::string_view content) {
  LvmHeader header;
  if (content.substr(0, kBegins.size()) != kBegins) return header;
  std::string_view rest = content;
  int ends = 0;  // one of the file's header, one of its channels'
  for (size_t line = 1; !rest.empty() && line <= kLongest && ends < 2; ++line) {
    const std::string_view text = take_line(rest);
    if (text.substr(0, kEnd.size()) == kEnd) header.lines = line, header.below = rest, ++ends;
    const std::vector<std::string> fields = fields_of(text);
    if (fields.size() < 2) continue;
    if (fields[0] == "Separator") header.separator = fields[1] == "Comma" ? ',' : '\t';
    if (fields[0] == "X_Columns") header.has_times = fields[1] != "No";
    if (fields[0] == "Delta_X" && header.step_s == 0.0) header.step_s = step_of(fields);
  }
  return header;
}

bool begins_lvm_segment(std::string_view lines) {
  constexpr size_t kChannelHeader = 20;  // lines
  for (size_t i = 0; i < kChannelHeader && !lines.empty(); ++i)
    if (take_line(lines).substr(0, kEnd.size()) == kEnd) return true;
  return false;
}

}  // namespace host_sim
