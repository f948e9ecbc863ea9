#include "host_sim/records/csv/rows/csv_table.hpp"

#include <algorithm>
#include <numeric>

#include "host_sim/records/columns/names/column_name.hpp"
#include "host_sim/records/csv/blanks/blank_ends.hpp"
#include "host_sim/records/csv/blanks/fill_blanks.hpp"
#include "host_sim/records/csv/text/text_lines.hpp"
#include "host_sim/records/files/data_file_error.hpp"

namespace host_sim {

std::string_view CsvTable::from(std::string_view row) const {
  return {row.data(), static_cast<size_t>(content.data() + content.size() - row.data())};
}

size_t CsvTable::line_of(size_t sample) const {
  const size_t row = row_of.empty() ? sample + left_out : row_of[sample];
  size_t line = layout.data_line + row;
  for (const size_t before : comments) line += before <= row ? 1 : 0;
  return line;
}

bool CsvTable::is_header(std::string_view row) const {
  const std::vector<std::string> fields = split_fields(row, layout.separator);
  return !layout.unnamed && fields.size() == layout.columns.size() &&
         std::equal(fields.begin(), fields.end(), layout.columns.begin(),
                    [](const std::string& a, const Column& b) { return trimmed_text(a) == trimmed_text(b.head); });
}

void CsvTable::refuse(size_t line, const std::string& problem) const {
  throw DataFileError(record.file, line, problem);
}

void CsvTable::keep_samples(size_t first, size_t end) {
  for (Channel& channel : record.channels) keep_rows(first, end, channel.values);
  if (!time_s.empty()) keep_rows(first, end, time_s);
  if (row_of.empty())
    left_out += first;
  else
    keep_rows(first, end, row_of);
  repeats.erase(std::remove_if(repeats.begin(), repeats.end(), [&](size_t i) { return i < first || i >= end; }),
                repeats.end());
  for (size_t& repeat : repeats) repeat -= first;
  samples = end - first;
}

void CsvTable::keep_samples(const std::vector<bool>& keep) {
  if (row_of.empty()) {
    row_of.resize(samples);
    std::iota(row_of.begin(), row_of.end(), left_out);
  }
  keep_only(keep, row_of);
  for (Channel& channel : record.channels) keep_only(keep, channel.values);
  keep_only(keep, time_s);
  repeats.clear();  // of rows that are no neighbours any more
  record.left_out_before.reset();
  samples = time_s.size();
}

}  // namespace host_sim
