// The stages, each a room: text as UTF-8 and in lines (text), where names, units and numbers stand (layout), what the columns mean
// (records/columns), numbers row by row (rows), and rows that lack values (blanks). A CsvTable goes from one to the next.
#include "host_sim/records/csv/csv_reader.hpp"

#include <utility>

#include "host_sim/records/columns/head_hints.hpp"
#include "host_sim/records/csv/blanks/repeated_rows.hpp"
#include "host_sim/records/csv/blanks/whole_rows.hpp"
#include "host_sim/records/csv/layout/csv_layout.hpp"
#include "host_sim/records/csv/rows/column_targets.hpp"
#include "host_sim/records/csv/rows/csv_rows.hpp"
#include "host_sim/records/csv/rows/csv_table.hpp"
#include "host_sim/records/csv/text/row_ends.hpp"
#include "host_sim/records/csv/text/text_encoding.hpp"
#include "host_sim/records/files/data_file_error.hpp"
#include "host_sim/records/record_checks.hpp"

namespace host_sim {
namespace {

bool is_rig_file(std::string_view content) {
  const std::string_view begins = "schema = \"rig/";
  return content.substr(0, begins.size()) == begins;
}

void require_table(std::string_view bytes, const std::string& file) {
  if (is_rig_file(bytes))
    throw DataFileError(file, 0, "is a rig file, which --rig takes, expected a table of measured values");
  if (const char* other = other_format(bytes))
    throw DataFileError(file, 0, std::string("is ") + other + ", expected a table of text: save it as CSV");
}

void find_layout_of(CsvTable& table, const rig_file::RigModel& model, const ReadingOptions& options) {
  if (table.content.find_first_not_of(" \t\r\n") == std::string_view::npos)
    table.refuse(0, "is empty, expected a line of column names, then numbers");
  table.layout =
      find_layout(table.content, [&](const std::string& head) { return means_channel(head, model, options); });
  const double step_s = table.layout.step_s;
  table.rate_Hz = options.sample_rate_Hz > 0.0 || !(step_s > 0.0) ? options.sample_rate_Hz : 1.0 / step_s;
  if (table.layout.header_line == 0) table.refuse(1, "holds no names of columns, expected t_s, then channels");
}

void find_times(bool resampled, CsvTable& table) {
  if (table.rate_Hz > 0.0) {
    if (table.samples < 2) table.refuse(0, "holds " + std::to_string(table.samples) + " samples, expected at least 2");
    table.record.sample_period_s = 1.0 / table.rate_Hz;
    return;
  }
  const auto set = resampled ? keep_times : set_time_base;
  set(
      table.time_s, [&table](size_t sample) { return table.line_of(sample); }, table.record);
}

}  // namespace

Record parse_csv(std::string_view content, const std::string& file, const rig_file::RigModel& model,
                 const ReadingOptions& options) {
  std::string buffer, undressed;
  const std::string_view text = as_utf8(content, buffer);
  for (const std::string_view bytes : {content, text}) require_table(bytes, file);
  const bool resampled = options.resample_Hz > 0.0;
  CsvTable table;
  table.content = without_row_ends(text, undressed);
  table.record.file = file;
  find_layout_of(table, model, options);
  find_targets(model, options, table);
  read_rows(table);
  if (table.lacks_times) leave_out_rest(table);
  leave_out_repeats(table);
  if (table.samples > 0) treat_blanks(resampled, table);
  find_times(resampled, table);
  return std::move(table.record);
}

}  // namespace host_sim
