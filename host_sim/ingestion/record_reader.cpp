#include "host_sim/ingestion/record_reader.hpp"

#include "host_sim/ingestion/mat/mat_reader.hpp"
#include "host_sim/ingestion/sensor_log/sensor_log_reader.hpp"
#include "host_sim/ingestion/uff/uff_reader.hpp"
#include "host_sim/records/csv/csv_reader.hpp"
#include "host_sim/records/derived/computed_columns.hpp"
#include "host_sim/records/files/data_file_error.hpp"
#include "host_sim/records/files/file_content.hpp"
#include "host_sim/records/files/input_files.hpp"
#include "host_sim/records/record_checks.hpp"
#include "host_sim/records/times/resample.hpp"
#include "host_sim/records/turns/joined_turns.hpp"

namespace host_sim {
namespace {

struct RecordFormat {
  const char* name;
  bool (*recognises)(const std::string& path, std::string_view content);
  std::vector<Record> (*read)(std::string_view content, const std::string& path, const rig_file::RigModel& model,
                              const ReadingOptions& options);
  TimesFrom times_from;
};

std::vector<Record> one(Record record) {
  std::vector<Record> records;
  records.push_back(std::move(record));
  return records;
}

// The first that recognises the file reads it; the last one takes all.
constexpr RecordFormat kFormats[] = {
    {"MAT", is_mat,
     [](std::string_view, const std::string& path, const rig_file::RigModel& model, const ReadingOptions& options) {
       return read_mat(path, model, options);
     },
     TimesFrom::kColumn},
    {"Universal File", is_uff, parse_uff, TimesFrom::kFile},
    {"CAN log", is_sensor_log,
     [](std::string_view content, const std::string& path, const rig_file::RigModel& model,
        const ReadingOptions& options) { return one(parse_sensor_log(content, path, model, options)); },
     TimesFrom::kFile},
    {"CSV", [](const std::string&, std::string_view) { return true; },
     [](std::string_view content, const std::string& path, const rig_file::RigModel& model,
        const ReadingOptions& options) { return one(parse_csv(content, path, model, options)); },
     TimesFrom::kColumn},
};

std::vector<Record> at_even_steps(const std::vector<Record>& records, double rate_Hz) {
  std::vector<Record> all;
  for (const Record& record : records)
    for (Record& part : resampled(record, rate_Hz)) {
      part.computed = record.computed, part.times_from = record.times_from;
      all.push_back(std::move(part));
    }
  return all;
}

}  // namespace

std::vector<Record> read_records(const std::string& path, const rig_file::RigModel& model,
                                 const ReadingOptions& options) {
  const FileContent content(path);
  note_input_file(path);
  for (const RecordFormat& format : kFormats) {
    if (!format.recognises(path, content.text())) continue;
    std::vector<Record> records = format.read(content.text(), path, model, options);
    for (const Record& record : records) require_motion_channels(record, model);
    for (Record& record : records)
      record.times_from = options.sample_rate_Hz > 0.0 ? TimesFrom::kUser : format.times_from;
    if (!options.span.is_all())
      for (Record& record : records) record = within(std::move(record), options.span);
    for (Record& record : records) join_turns(record), leave_out_computed(record);
    if (options.resample_Hz > 0.0) return at_even_steps(records, options.resample_Hz);
    return records;
  }
  throw DataFileError(path, 0, "is of no known format, expected CSV, MAT, Universal File 58 or a CAN log");
}

Record read_record(const std::string& path, const rig_file::RigModel& model, const ReadingOptions& options) {
  std::vector<Record> records = read_records(path, model, options);
  if (records.size() != 1)
    throw DataFileError(path, 0, "holds " + std::to_string(records.size()) + " records, expected one");
  return std::move(records.front());
}

}  // namespace host_sim
