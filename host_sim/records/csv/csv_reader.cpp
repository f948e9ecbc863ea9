#include "host_sim/records/csv/csv_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "host_sim/records/columns/column_name.hpp"
#include "host_sim/records/csv/around_values.hpp"
#include "host_sim/records/csv/blank_ends.hpp"
#include "host_sim/records/csv/clock_time.hpp"
#include "host_sim/records/csv/csv_layout.hpp"
#include "host_sim/records/csv/decimal_number.hpp"
#include "host_sim/records/csv/fill_blanks.hpp"
#include "host_sim/records/csv/held_commands.hpp"
#include "host_sim/records/csv/lvm_header.hpp"
#include "host_sim/records/csv/row_ends.hpp"
#include "host_sim/records/csv/text_encoding.hpp"
#include "host_sim/records/data_file_error.hpp"
#include "host_sim/records/even_times.hpp"
#include "host_sim/records/record_checks.hpp"

namespace host_sim {
namespace {

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text.substr(0, 40)) result += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
  return result + (text.size() > 40 ? "...\"" : "\"");
}

const char* separator_word(char separator) {
  return separator == ',' ? "commas" : separator == ';' ? "semicolons" : separator == '\t' ? "tabs" : "blanks";
}

class CsvParser {
 public:
  CsvParser(std::string_view content, const std::string& file, const rig_file::RigModel& model,
            const ReadingOptions& options)
      : content_(content), model_(model), options_(options) {
    record_.file = file;
  }

  Record parse() {
    if (content_.find_first_not_of(" \t\r\n") == std::string_view::npos)
      refuse(0, "is empty, expected a line of column names, then numbers");
    layout_ = find_layout(content_, [this](const std::string& head) { return means_channel(head, model_, options_); });
    rate_Hz_ =
        options_.sample_rate_Hz > 0.0 || !(layout_.step_s > 0.0) ? options_.sample_rate_Hz : 1.0 / layout_.step_s;
    if (layout_.header_line == 0) refuse(1, "holds no names of columns, expected t_s, then channels");
    plan();
    reserve();
    std::string_view rest = layout_.data;
    for (line_ = layout_.data_line; !rest.empty(); ++line_) {
      const std::string_view row = take_line(rest);
      const bool numbers = !row.empty() && begins_number(row.front());
      if (!numbers && is_comment(row)) {
        comments_.push_back(samples_);
      } else if (!numbers && is_blank(row)) {
        if (begins_lvm_segment(rest)) refuse_segment();
        if (!ends_before(rest)) refuse(line_, "is blank, expected " + std::to_string(columns_.size()) + " numbers");
        break;
      } else if (samples_ > 0 && rest.empty() && breaks_off(row)) {
        record_.notes.push_back("left out: the last line, which breaks off in the middle");
      } else if (!numbers && samples_ > 0 && !begins_like_number(row) && ends_with_text(row)) {
        break;
      } else {
        if (samples_ > 0 && row == row_) repeats_.push_back(samples_);
        read_row(row);
        ++samples_;
      }
    }
    finish();
    return std::move(record_);
  }

 private:
  struct Target {
    std::vector<double>* values = nullptr;  // nullptr: ignored
    double factor = 1.0;
    std::string name;
  };

  [[noreturn]] void refuse(size_t line, const std::string& problem) const {
    throw DataFileError(record_.file, line, problem);
  }

  void plan() {
    const std::string first = trimmed_text(layout_.columns.empty() ? "" : layout_.columns.front().head);
    ColumnPlan plan = plan_columns(layout_.columns, model_, options_, record_.file, layout_.header_line);
    const auto channels =
        static_cast<size_t>(std::count_if(plan.uses.begin(), plan.uses.end(),
                                          [](const ColumnUse& use) { return use.kind == ColumnUse::Kind::kChannel; }));
    if (layout_.unnamed && (channels == 0 || (!plan.has_time() && rate_Hz_ <= 0.0)))
      refuse(layout_.header_line, "holds no names of columns above its " + std::to_string(plan.uses.size()) +
                                      " columns of numbers, expected to be told which is which, as in --column t=1 "
                                      "--column displacement_1=2, or --sample-rate in place of the time" +
                                      (layout_.unfit.empty() ? "" : "; " + layout_.unfit));
    if (!plan.has_time() && rate_Hz_ <= 0.0)
      refuse(layout_.header_line, "has no column of time (the first is " + quoted(first) +
                                      "), expected t_s, then channels, or --sample-rate, or --column t=NAME for a "
                                      "time with a name of its own (and --unit t=ms where it is in ms)");
    if (channels == 0) refuse_without_channels();
    record_.notes = layout_.notes;
    record_.notes.insert(record_.notes.end(), plan.notes.begin(), plan.notes.end());
    record_.channels.reserve(channels);
    for (size_t i = 0; i < plan.uses.size(); ++i) {
      ColumnUse& use = plan.uses[i];
      Target target;
      target.name = use.kind == ColumnUse::Kind::kTime ? trimmed_text(layout_.columns[i].head) : use.channel.name;
      target.factor = use.factor;
      if (use.kind == ColumnUse::Kind::kTime && !(layout_.step_s > 0.0)) target.values = &time_s_;
      if (use.kind == ColumnUse::Kind::kChannel) {
        record_.channels.push_back(std::move(use.channel));
        target.values = &record_.channels.back().values;  // room was reserved: it stays there
      }
      columns_.push_back(std::move(target));
      if (columns_.back().values != nullptr) needed_ = columns_.size();
    }
  }

  [[noreturn]] void refuse_without_channels() const {
    std::string heads;
    for (const Column& column : layout_.columns)
      heads += (heads.empty() ? "" : ", ") + quoted(trimmed_text(column.head));
    refuse(layout_.header_line, "names no channel (" + heads +
                                    "), expected t_s and at least one such as displacement_1_m, or " +
                                    plain_name_hint(layout_.columns, model_) + " for columns with names of their own");
  }

  void reserve() {
    const size_t line_length = layout_.data.find('\n');
    if (line_length == std::string_view::npos || line_length == 0) return;
    const size_t rows = layout_.data.size() / (line_length + 1) * 21 / 20 + 1;  // the first rows are often the shortest
    for (const Target& column : columns_)
      if (column.values != nullptr) column.values->reserve(rows);
  }

  // The file's end within a line, as a logger leaves it that was switched off: no line end behind it, and fewer fields.
  bool breaks_off(std::string_view row) const {
    if (row.data() + row.size() != content_.data() + content_.size()) return false;
    const char* position = row.data();
    const char* end = row.data() + row.size();
    size_t fields = 1;
    for (skip_field(position, end); position != end; skip_field(++position, end)) ++fields;
    return fields < columns_.size();
  }

  std::string_view from(std::string_view row) const {
    return {row.data(), static_cast<size_t>(content_.data() + content_.size() - row.data())};
  }
  [[noreturn]] void refuse_segment() const {
    refuse(line_, "begins a second segment with a header of its own, expected one: save each as a file");
  }

  // Whether nothing but text follows, which is said.
  bool ends_before(std::string_view lines) {
    const std::optional<size_t> text = text_below(lines);
    if (text && *text > 0)
      record_.notes.push_back("left out: " + std::to_string(*text) + (*text == 1 ? " line" : " lines") +
                              " of text below the last row of numbers");
    return text.has_value();
  }
  // Of a table whose rows begin with numbers. The names again and a row without a time are none of it.
  bool ends_with_text(std::string_view row) {
    std::string_view data = layout_.data;
    if (begins_lvm_segment(from(row)) || !begins_like_number(take_line(data)) || is_header(row) ||
        says_no_value(first_field(row)))
      return false;
    return ends_before(from(row));
  }
  std::string first_field(std::string_view row) const {
    return trimmed_text(split_fields(row, layout_.separator).front());
  }
  bool is_header(std::string_view row) const {
    const std::vector<std::string> fields = split_fields(row, layout_.separator);
    return !layout_.unnamed && fields.size() == layout_.columns.size() &&
           std::equal(fields.begin(), fields.end(), layout_.columns.begin(),
                      [](const std::string& a, const Column& b) { return trimmed_text(a) == trimmed_text(b.head); });
  }

  void read_row(std::string_view row) {
    row_ = row;
    const char* position = row.data();
    const char* end = row.data() + row.size();
    const char separator = layout_.separator;
    if (separator == ' ')
      while (end != position && (end[-1] == ' ' || end[-1] == '\t')) --end;
    const size_t count = columns_.size();
    for (size_t column = 0; column < count; ++column) {
      const Target& target = columns_[column];
      if (target.values == nullptr) {
        skip_field(position, end);
      } else {
        double value = 0.0;
        if (take_plain(position, end, value))
          value *= target.factor;
        else if (target.values != &time_s_ || !take_clock(position, end, value))
          value = number(position, end, target) * target.factor;
        target.values->push_back(value);
      }
      const bool last = column + 1 == count;
      if (position == end && column + 1 >= needed_) return;                        // what is left out is ignored anyway
      if (last && end - position == 1 && at_field_end(position, end)) ++position;  // a separator ends the line
      if (last && count > needed_) return;  // what has no name is ignored as the columns before it are
      if (last != (position == end))
        refuse(line_,
               (last ? "has more fields, expected " : "has " + std::to_string(column + 1) + " fields, expected ") +
                   std::to_string(count) + " numbers separated by " + separator_word(separator) +
                   (samples_ == 0 ? ", as many as line " + std::to_string(layout_.header_line) + " has names" : ""));
      if (!last) ++position;
    }
  }

  static bool begins_number(char c) { return static_cast<unsigned char>(c - '0') < 10 || c == '-'; }

  // A number with nothing around it, as nearly all fields are. False: it is looked at more closely, from where it begins.
  bool take_plain(const char*& position, const char* end, double& value) const {
    if (layout_.decimal_comma || position == end || !begins_number(*position)) return false;
    const auto [stop, error] = read_decimal(position, end, value);
    if (error != std::errc() || !at_field_end(stop, end) || !std::isfinite(value)) return false;
    position = stop;
    return true;
  }

  // A time of day, perhaps with a date, as seconds since the first row's. Past midnight without a date it goes on.
  bool take_clock(const char*& position, const char* end, double& value) {
    const char* stop = position;
    skip_field(stop, end);
    if (std::find(position, stop, ':') == stop) return false;
    std::string text = trimmed_text(std::string(position, stop));
    text.erase(std::remove(text.begin(), text.end(), '"'), text.end());
    const std::optional<ClockTime> clock = parse_clock_time(text);
    if (!clock) return false;
    if (samples_ == 0) first_clock_ = *clock;
    value = 86400.0 * static_cast<double>(clock->day - first_clock_.day) + (clock->time_s - first_clock_.time_s);
    while (clock->day == 0 && !time_s_.empty() && value < time_s_.back() - 43200.0) value += 86400.0;
    position = stop;
    return true;
  }

  void skip_blanks(const char*& position, const char* end) const {
    while (position != end && (*position == ' ' || (*position == '\t' && layout_.separator != '\t'))) ++position;
  }
  bool at_field_end(const char* position, const char* end) const {
    return position == end || *position == layout_.separator || (layout_.separator == ' ' && *position == '\t');
  }

  void skip_field(const char*& position, const char* end) const {
    skip_blanks(position, end);
    for (bool inside = false; position != end && (inside || !at_field_end(position, end)); ++position)
      if (*position == '"') inside = !inside;
  }

  // The number at the position, which moves to the separator behind it or to the end.
  double number(const char*& position, const char* end, const Target& target) {
    const char* const start = position;
    skip_blanks(position, end);
    if (take_blank(position, end)) {
      lacks_times_ = lacks_times_ || target.values == &time_s_;
      return std::numeric_limits<double>::quiet_NaN();
    }
    const bool in_quotes = position != end && *position == '"';
    if (in_quotes) ++position;
    if (position != end && *position == '+') ++position;
    double value = 0.0;
    bool good = false;
    if (layout_.decimal_comma) {
      good = number_with_comma(position, end, value);
    } else {
      const auto [stop, error] = read_decimal(position, end, value);
      good = error == std::errc();
      position = stop;
    }
    if (in_quotes) {
      good = good && position != end && *position == '"';
      if (good) ++position;
    }
    if (layout_.separator != ' ') skip_blanks(position, end);
    if (!good || !at_field_end(position, end) || !std::isfinite(value)) refuse_field(start, end, target);
    return value;
  }

  // A field without a value: nothing, or "NaN".
  bool take_blank(const char*& position, const char* end) {
    const char c = position == end ? ' ' : *position;
    const char* const next = position == end ? end : position + 1;
    if ((c == '-' || c == '+') && next != end && ((*next >= '0' && *next <= '9') || *next == '.')) return false;
    if ((c >= '0' && c <= '9' && !(c == '1' && end - position > 2 && position[2] == '#')) || c == '.') return false;
    const char* stop = position;
    skip_field(stop, end);
    std::string field = trimmed_text(std::string(position, stop));
    if (field.size() > 1 && field.front() == '"' && field.back() == '"') field = field.substr(1, field.size() - 2);
    if (!says_no_value(field)) return false;
    position = stop;
    blank_ = field;
    return true;
  }

  static bool number_with_comma(const char*& position, const char* end, double& value) {
    char digits[64];
    size_t length = 0;
    const char* at = position;
    for (; at != end && length < sizeof digits && std::strchr("+-0123456789eE,", *at) != nullptr; ++at)
      digits[length++] = *at == ',' ? '.' : *at;
    const auto [stop, error] = read_decimal(digits, digits + length, value);
    position += stop - digits;
    return error == std::errc();
  }

  [[noreturn]] void refuse_field(const char* start, const char* end, const Target& target) const {
    const char* stop = start;
    skip_field(stop, end);
    const std::string field = trimmed_text(std::string(start, stop));
    std::string expected = ", expected a finite number";
    if (layout_.decimal_comma && field.find('.') != std::string::npos)
      expected += " with a decimal comma, as in the first rows";
    const auto commas = std::count(field.begin(), field.end(), ',');
    if (!layout_.decimal_comma && layout_.separator != ',' && commas == 1)
      expected += " with a decimal point, as in the first rows";
    if (layout_.separator != ',' && commas > 1)
      expected += std::string(", fields separated by ") + separator_word(layout_.separator) + " as the names are";
    if (begins_lvm_segment(from(row_))) refuse_segment();
    if (is_header(row_))
      refuse(line_,
             "holds the names of the columns again, as where a second recording begins: give each a file of its "
             "own, or take the line out");
    if (!field.empty() && !begins_like_number(field) && field.find_first_of(",;") == std::string::npos)
      expected += "; left blank, --resample fills it in";
    refuse(line_, "column " + target.name + " is " + quoted(field) + expected);
  }

  size_t line_of(size_t sample) const {
    sample += left_out_;
    for (const size_t gone : gone_) sample += gone <= sample ? 1 : 0;
    size_t line = layout_.data_line + sample;
    for (const size_t before : comments_) line += before <= sample ? 1 : 0;
    return line;
  }

  [[noreturn]] void refuse_blank(const BlankEnds& blank, const std::vector<TableColumn>& table) const {
    const bool between = !blank.gap.empty();
    std::string expected = ", expected a finite number";
    if (const double step_s = between && !time_s_.empty() ? fastest_step(time_s_, table) : 0.0; step_s > 0.0)
      expected += fmt::format("; --resample {:.4g} fills single values that are missing", 1.0 / step_s);
    refuse(line_of(between ? blank.gap_row : 0),
           "column " + (between ? blank.gap : blank.names) + " is " + quoted(blank_) + expected);
  }

  // Of what is to be interpolated anyway. Each channel from its own values; rows in a long gap go.
  void fill_between(const std::vector<TableColumn>& table) {
    record_.own_step_s = fastest_step(time_s_, table);
    const FilledBlanks blanks = fill_blanks(time_s_, table);
    for (Channel& channel : record_.channels) keep_only(blanks.keep, channel.values);
    keep_only(blanks.keep, time_s_);
    samples_ = time_s_.size();
    record_.notes.push_back(
        "without a value of " + blanks.names + " in some rows: " + std::to_string(blanks.filled) +
        " values interpolated" +
        (blanks.left_out > 0 ? ", " + std::to_string(blanks.left_out) + " rows in longer gaps left out" : ""));
  }

  // A table beside a longer one ends before the file does.
  void leave_out_rest() {
    const auto nothing = [](double value) { return std::isnan(value); };
    size_t end = time_s_.size();
    while (end > 0 && nothing(time_s_[end - 1]) &&
           std::all_of(record_.channels.begin(), record_.channels.end(),
                       [&](const Channel& channel) { return nothing(channel.values[end - 1]); }))
      --end;
    const auto gap = std::find_if(time_s_.begin(), time_s_.begin() + static_cast<std::ptrdiff_t>(end), nothing);
    if (gap != time_s_.begin() + static_cast<std::ptrdiff_t>(end))
      refuse(line_of(static_cast<size_t>(gap - time_s_.begin())), "its time is \"\", expected a finite number");
    if (end == time_s_.size()) return;
    record_.notes.push_back("left out: " + std::to_string(time_s_.size() - end) +
                            " rows at the end that hold nothing of it");
    keep_samples(0, end);
  }

  // Of rows that bear the time of the one before, whether all are it word by word, many of them, and no others: then they stand twice.
  // A clock in coarse ticks has such rows too while the sensors rest.
  bool stand_twice(const std::vector<bool>& keep) const {
    constexpr double kMany = 0.05, kResting = 0.1;  // of the rows
    size_t of_one_time = 0, resting = 0;
    for (size_t i = 1; i < samples_; ++i) {
      of_one_time += time_s_[i] == time_s_[i - 1] ? 1 : 0;
      resting += keep[i] && std::all_of(record_.channels.begin(), record_.channels.end(), [i](const Channel& channel) {
                   return channel.values[i] == channel.values[i - 1];
                 });
    }
    const auto rows = static_cast<double>(samples_), many = static_cast<double>(repeats_.size());
    return of_one_time == repeats_.size() && of_one_time + 1 < samples_ && many > kMany * rows &&
           static_cast<double>(resting) < kResting * (rows - many);
  }

  void leave_out_repeats() {
    if (repeats_.empty() || rate_Hz_ > 0.0) return;
    std::vector<bool> keep(samples_, true);
    for (const size_t sample : repeats_) keep[sample] = false;
    if (!stand_twice(keep)) return;
    for (Channel& channel : record_.channels) keep_only(keep, channel.values);
    keep_only(keep, time_s_);
    samples_ = time_s_.size();
    gone_ = std::move(repeats_);
    record_.notes.push_back(fmt::format("left out: {} rows that stand twice", gone_.size()));
  }

  // Rows at the ends that lack a value go; one that lacks it between is refused, or filled where the record is interpolated.
  void treat_blanks() {
    const bool fills = options_.resample_Hz > 0.0 && !time_s_.empty();
    if (fills)
      for (std::string& note : hold_commands(time_s_, record_.channels)) record_.notes.push_back(std::move(note));
    std::vector<TableColumn> table, measured;
    for (Channel& channel : record_.channels) {
      table.push_back({channel.name, &channel.values});
      if (!channel.held) measured.push_back(table.back());
    }
    const BlankEnds blank = find_blank_ends(table);
    if ((!blank.gap.empty() && !fills) || blank.first == blank.end) refuse_blank(blank, table);
    leave_out_ends(blank);
    if (!blank.gap.empty()) fill_between(measured);
  }

  void keep_samples(size_t first, size_t end) {
    for (Channel& channel : record_.channels) keep_rows(first, end, channel.values);
    if (!time_s_.empty()) keep_rows(first, end, time_s_);
    samples_ = end - first;
  }

  void leave_out_ends(const BlankEnds& blank) {
    const size_t gone = blank.at_start + blank.at_end;
    if (gone == 0) return;
    keep_samples(blank.first, blank.end);
    left_out_ = blank.at_start;
    record_.notes.push_back("left out: " + std::to_string(blank.at_start) + " rows at the start and " +
                            std::to_string(blank.at_end) + " at the end without a value of " + blank.names);
  }

  void finish() {
    if (lacks_times_) leave_out_rest();
    leave_out_repeats();
    if (samples_ > 0) treat_blanks();
    if (rate_Hz_ > 0.0) {
      if (samples_ < 2) refuse(0, "holds " + std::to_string(samples_) + " samples, expected at least 2");
      record_.sample_period_s = 1.0 / rate_Hz_;
    } else {
      const auto set = options_.resample_Hz > 0.0 ? keep_times : set_time_base;
      set(
          time_s_, [this](size_t sample) { return line_of(sample); }, record_);
    }
  }

  std::string_view content_;
  const rig_file::RigModel& model_;
  const ReadingOptions& options_;
  CsvLayout layout_;
  Record record_;
  std::vector<Target> columns_;
  double rate_Hz_ = 0.0;  // that is told in place of times; 0: it is not
  size_t needed_ = 0;     // so many of them, to the last that is not ignored
  std::vector<double> time_s_;
  ClockTime first_clock_;
  std::vector<size_t> comments_;  // how many samples stood before each comment line among the rows
  size_t line_ = 1, samples_ = 0;
  std::string_view row_;  // that is being read
  std::vector<size_t> repeats_,
      gone_;                  // samples whose row is the one before, word by word; those of them that were left out
  bool lacks_times_ = false;  // in some rows
  size_t left_out_ = 0;       // rows before the first sample
  std::string blank_;         // the last field without a value: "" or "NaN"
};

bool is_rig_file(std::string_view content) {
  const std::string_view begins = "schema = \"rig/";
  return content.substr(0, begins.size()) == begins;
}

}  // namespace

Record parse_csv(std::string_view content, const std::string& file, const rig_file::RigModel& model,
                 const ReadingOptions& options) {
  std::string buffer;
  const std::string_view text = as_utf8(content, buffer);
  for (const std::string_view bytes : {content, text}) {
    if (is_rig_file(bytes))
      throw DataFileError(file, 0, "is a rig file, which --rig takes, expected a table of measured values");
    if (const char* other = other_format(bytes))
      throw DataFileError(file, 0, std::string("is ") + other + ", expected a table of text: save it as CSV");
  }
  std::string undressed;
  return CsvParser(without_row_ends(text, undressed), file, model, options).parse();
}

}  // namespace host_sim
