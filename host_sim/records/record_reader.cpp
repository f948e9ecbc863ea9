#include "host_sim/records/record_reader.hpp"

#include <cstdio>
#include <memory>

#include "host_sim/ingestion/mat_reader.hpp"
#include "host_sim/ingestion/sensor_log_reader.hpp"
#include "host_sim/ingestion/uff_reader.hpp"
#include "host_sim/records/csv_reader.hpp"
#include "host_sim/records/data_file_error.hpp"
#include "host_sim/records/record_checks.hpp"

namespace host_sim {
namespace {

struct RecordFormat {
  const char* name;
  bool (*recognises)(const std::string& path, std::string_view content);
  Record (*read)(std::string_view content, const std::string& path, const rig_file::RigModel& model);
};

// The first that recognises the file reads it; the last one takes all.
constexpr RecordFormat kFormats[] = {
    {"MAT", is_mat,
     [](std::string_view, const std::string& path, const rig_file::RigModel& model) { return read_mat(path, model); }},
    {"Universal File", is_uff, parse_uff},
    {"candump log", is_sensor_log, parse_sensor_log},
    {"CSV", [](const std::string&, std::string_view) { return true; }, parse_csv},
};

}  // namespace

std::string read_whole_file(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) throw DataFileError(path, 0, "cannot be opened, expected a readable data file");
  std::string content;
  char chunk[1 << 16];
  for (size_t got = 0; (got = std::fread(chunk, 1, sizeof chunk, file.get())) > 0;) content.append(chunk, got);
  if (std::ferror(file.get()) != 0)
    throw DataFileError(path, 0, "cannot be read, expected a readable data file, not a folder");
  return content;
}

Record read_record(const std::string& path, const rig_file::RigModel& model) {
  const std::string content = read_whole_file(path);
  for (const RecordFormat& format : kFormats) {
    if (!format.recognises(path, content)) continue;
    Record record = format.read(content, path, model);
    require_motion_channels(record, model);
    return record;
  }
  throw DataFileError(path, 0, "is of no known format, expected CSV, MAT, Universal File 58 or a candump log");
}

}  // namespace host_sim
