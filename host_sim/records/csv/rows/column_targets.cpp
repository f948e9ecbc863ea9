#include "host_sim/records/csv/rows/column_targets.hpp"

#include <algorithm>
#include <utility>

#include "host_sim/records/columns/column_meaning.hpp"
#include "host_sim/records/columns/head_hints.hpp"
#include "host_sim/records/columns/names/column_name.hpp"
#include "host_sim/records/columns/quoted.hpp"

namespace host_sim {
namespace {

[[noreturn]] void refuse_without_channels(const rig_file::RigModel& model, const CsvTable& table) {
  const std::vector<Column>& columns = table.layout.columns;
  table.refuse(table.layout.header_line, "names no channel (" + quoted_heads(columns) +
                                             "), expected t_s and at least one such as displacement_1_m, or " +
                                             plain_name_hint(columns, model) + " for columns with names of their own");
}

void require_channels_and_times(const ColumnPlan& plan, size_t channels, const rig_file::RigModel& model,
                                const CsvTable& table) {
  const CsvLayout& layout = table.layout;
  const bool timeless = !plan.has_time() && table.rate_Hz <= 0.0;
  if (layout.unnamed && (channels == 0 || timeless))
    table.refuse(layout.header_line, "holds no names of columns above its " + std::to_string(plan.uses.size()) +
                                         " columns of numbers, expected to be told which is which, as in --column t=1 "
                                         "--column displacement_1=2, or --sample-rate in place of the time" +
                                         (layout.unfit.empty() ? "" : "; " + layout.unfit));
  const std::string first = trimmed_text(layout.columns.empty() ? "" : layout.columns.front().head);
  if (timeless)
    table.refuse(layout.header_line, "has no column of time (the first is " + quoted(first) +
                                         "), expected t_s, then channels, or --sample-rate, or --column t=NAME for a "
                                         "time with a name of its own (and --unit t=ms where it is in ms)");
  if (channels == 0) refuse_without_channels(model, table);
}

void reserve(CsvTable& table) {
  const std::string_view data = table.layout.data;
  const size_t line_length = data.find('\n');
  if (line_length == std::string_view::npos || line_length == 0) return;
  const size_t rows = data.size() / (line_length + 1) * 21 / 20 + 1;  // the first rows are often the shortest
  for (const Target& column : table.targets)
    if (column.values != nullptr) column.values->reserve(rows);
}

}  // namespace

void find_targets(const rig_file::RigModel& model, const ReadingOptions& options, CsvTable& table) {
  const CsvLayout& layout = table.layout;
  Record& record = table.record;
  ColumnPlan plan = plan_columns(layout.columns, model, options, record.file, layout.header_line);
  const auto channels = static_cast<size_t>(std::count_if(
      plan.uses.begin(), plan.uses.end(), [](const ColumnUse& use) { return use.kind == ColumnUse::Kind::kChannel; }));
  require_channels_and_times(plan, channels, model, table);
  record.notes = layout.notes;
  record.notes.insert(record.notes.end(), plan.notes.begin(), plan.notes.end());
  record.channels.reserve(channels);
  for (size_t i = 0; i < plan.uses.size(); ++i) {
    ColumnUse& use = plan.uses[i];
    Target target;
    target.name = use.kind == ColumnUse::Kind::kTime ? trimmed_text(layout.columns[i].head) : use.channel.name;
    target.factor = use.factor;
    if (use.kind == ColumnUse::Kind::kTime && !(layout.step_s > 0.0)) target.values = &table.time_s;
    if (use.kind == ColumnUse::Kind::kChannel) {
      record.channels.push_back(std::move(use.channel));
      target.values = &record.channels.back().values;  // room was reserved: it stays there
    }
    table.targets.push_back(std::move(target));
    if (table.targets.back().values != nullptr) table.needed = table.targets.size();
  }
  reserve(table);
}

}  // namespace host_sim
