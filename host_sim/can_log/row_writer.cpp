#include "host_sim/can_log/row_writer.hpp"

#include <fmt/format.h>

#include <charconv>

namespace can_log {
namespace {

// The fewest digits that read back as the same number; nothing where there is none.
std::string number(double value, const char* none) {
  if (!std::isfinite(value)) return none;
  char text[32];
  const std::to_chars_result end = std::to_chars(text, text + sizeof text, value);
  return std::string(text, end.ptr);
}

std::string seconds(const LogEntry& entry, const char* none) {
  if (!entry.has_time) return none;
  return fmt::format("{}.{:06}", entry.frame.time_ns / 1000000000u, entry.frame.time_ns / 1000u % 1000000u);
}

// Names of interfaces come from the log: what would break a row becomes an underscore.
std::string quoted(const std::string& text, bool quotes) {
  std::string safe;
  for (const char c : text) safe += c == '"' || c == '\\' || c == ',' || static_cast<unsigned char>(c) < 0x20 ? '_' : c;
  return quotes ? "\"" + safe + "\"" : safe;
}

struct Row {
  std::string key, rest;  // interface, sender, frame and name; value, std, unit and status
};

Row csv_row(const LogEntry& entry, const FrameReadings& frame, const Reading& reading) {
  return {quoted(entry.interface, false) + "," + frame.sender + "," + frame.frame + "," + reading.name + ",",
          number(reading.value, "") + "," + number(reading.std, "") + "," + reading.unit + "," + reading.status};
}

Row json_row(const LogEntry& entry, const FrameReadings& frame, const Reading& reading) {
  return {"\"interface\":" + quoted(entry.interface, true) + ",\"sender\":" + quoted(frame.sender, true) +
              ",\"frame\":" + quoted(frame.frame, true) + ",\"name\":" + quoted(reading.name, true),
          ",\"value\":" + number(reading.value, "null") + ",\"std\":" + number(reading.std, "null") +
              ",\"unit\":" + quoted(reading.unit, true) + ",\"status\":" + quoted(reading.status, true)};
}

}  // namespace

RowWriter::RowWriter(std::ostream& output, RowFormat format, bool changes_only)
    : output_(output), format_(format), changes_only_(changes_only) {
  if (format_ == RowFormat::kCsv) output_ << "time_s,interface,sender,frame,name,value,std,unit,status\n";
}

bool RowWriter::write(const LogEntry& entry) {
  FrameReadings frame;
  const bool known = reader_.read(entry, frame);
  for (const Reading& reading : frame.readings) {
    const bool csv = format_ == RowFormat::kCsv;
    const Row row = csv ? csv_row(entry, frame, reading) : json_row(entry, frame, reading);
    if (changes_only_) {
      std::string& last = last_[row.key];
      if (last == row.rest) continue;
      last = row.rest;
    }
    if (csv) {
      output_ << seconds(entry, "") << "," << row.key << row.rest << "\n";
    } else {
      output_ << "{\"time_s\":" << seconds(entry, "null") << "," << row.key << row.rest << "}\n";
    }
  }
  return known;
}

}  // namespace can_log
