#include "host_sim/records/csv_reader.hpp"

#include <charconv>
#include <cmath>

#include "host_sim/records/data_file_error.hpp"
#include "host_sim/records/record_checks.hpp"

namespace host_sim {
namespace {

// Takes the text up to the next separator (or the end) off the front.
std::string_view take_until(std::string_view& rest, char separator) {
  const size_t end = rest.find(separator);
  const std::string_view piece = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  return piece;
}

std::string_view trimmed(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text.substr(0, 40)) result += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
  return result + (text.size() > 40 ? "...\"" : "\"");
}

class CsvParser {
 public:
  CsvParser(std::string_view content, const std::string& file, const rig_file::RigModel& model)
      : rest_(content), model_(model) {
    record_.file = file;
    if (rest_.substr(0, 3) == "\xEF\xBB\xBF") rest_.remove_prefix(3);
  }

  Record parse() {
    if (trimmed(rest_).empty() || rest_.find_first_not_of(" \t\r\n") == std::string_view::npos)
      refuse(0, "is empty, expected a line of column names, then numbers");
    read_header(take_until(rest_, '\n'));
    reserve();
    for (line_ = 2; !rest_.empty(); ++line_) read_row(take_until(rest_, '\n'));
    set_time_base(time_s_, 2, record_);
    return std::move(record_);
  }

 private:
  [[noreturn]] void refuse(size_t line, const std::string& problem) const {
    throw DataFileError(record_.file, line, problem);
  }

  void read_header(std::string_view header) {
    const std::string_view first = trimmed(take_until(header, ','));
    if (first != "t_s")
      refuse(1, "first column is " + quoted(first) + ", expected t_s, then channels, separated by commas");
    while (!header.empty()) {
      const std::string name(trimmed(take_until(header, ',')));
      Channel channel = channel_of_name(name, model_, record_.file, 1);
      if (record_.find(channel.quantity, channel.dof) != nullptr)
        refuse(1, "column " + quoted(name) + " stands twice, expected each channel once");
      record_.channels.push_back(std::move(channel));
    }
    if (record_.channels.empty()) refuse(1, "names no channel, expected t_s and at least one such as displacement_1_m");
  }

  void reserve() {
    const size_t line_length = rest_.find('\n');
    if (line_length == std::string_view::npos || line_length == 0) return;
    const size_t rows = rest_.size() / line_length + 1;
    time_s_.reserve(rows);
    for (Channel& channel : record_.channels) channel.values.reserve(rows);
  }

  void read_row(std::string_view row) {
    if (trimmed(row).empty()) {
      if (rest_.find_first_not_of(" \t\r\n") != std::string_view::npos)
        refuse(line_, "is blank, expected " + std::to_string(record_.channels.size() + 1) + " numbers");
      rest_ = {};
      return;
    }
    const char* position = row.data();
    const char* const end = row.data() + row.size();
    const size_t columns = record_.channels.size() + 1;
    for (size_t column = 0; column < columns; ++column) {
      const double value = number(position, end, column);
      (column == 0 ? time_s_ : record_.channels[column - 1].values).push_back(value);
      const bool last = column + 1 == columns;
      if (last != (position == end))
        refuse(line_,
               (last ? "has more fields, expected " : "has " + std::to_string(column + 1) + " fields, expected ") +
                   std::to_string(columns) + " numbers separated by commas");
      if (!last) ++position;
    }
  }

  // The number at the position, which moves to the comma behind it or to the end.
  double number(const char*& position, const char* end, size_t column) const {
    const char* const start = position;
    const auto skip_blanks = [&] {
      while (position != end && (*position == ' ' || *position == '\t' || *position == '\r')) ++position;
    };
    skip_blanks();
    if (position != end && *position == '+') ++position;
    double value = 0.0;
    const auto [stop, error] = std::from_chars(position, end, value);
    position = stop;
    skip_blanks();
    if (error != std::errc() || (position != end && *position != ',') || !std::isfinite(value)) {
      std::string_view field(start, static_cast<size_t>(end - start));
      field = trimmed(field.substr(0, field.find(',')));
      const std::string name = column == 0 ? "t_s" : record_.channels[column - 1].name;
      refuse(line_, "column " + name + " is " + quoted(field) + ", expected a finite number");
    }
    return value;
  }

  std::string_view rest_;
  const rig_file::RigModel& model_;
  Record record_;
  std::vector<double> time_s_;
  size_t line_ = 1;
};

}  // namespace

Record parse_csv(std::string_view content, const std::string& file, const rig_file::RigModel& model) {
  return CsvParser(content, file, model).parse();
}

}  // namespace host_sim
