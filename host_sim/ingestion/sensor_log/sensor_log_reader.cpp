#include "host_sim/ingestion/sensor_log/sensor_log_reader.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include "hal/rig_file/channel_name.hpp"
#include "host_sim/can_log/log_reader.hpp"
#include "host_sim/ingestion/channel_options.hpp"
#include "host_sim/ingestion/sensor_log/log_calibration.hpp"
#include "host_sim/ingestion/sensor_log/log_times.hpp"
#include "host_sim/ingestion/sensor_log/sample_numbers.hpp"
#include "host_sim/records/columns/plan/column_choices.hpp"
#include "host_sim/records/files/data_file_error.hpp"
#include "host_sim/records/files/file_extension.hpp"
#include "host_sim/records/record_checks.hpp"

namespace host_sim {
namespace {

// A log of a candump without options has no times at all: then the user tells the rate.
bool usable(const can_log::LogEntry& entry, const LogTimes& times) {
  return (entry.has_time || times.none()) && !entry.frame.error && !entry.frame.remote;
}

LogTimes times_of(const std::string& text) {
  std::istringstream input(text);
  can_log::LogReader reader(input);
  can_log::LogEntry entry;
  LogTimes times;
  while (reader.next(entry)) times.learn(entry);
  return times;
}

LogCalibration calibration_of(const std::string& text, const std::string& file, const rig_file::RigModel& model,
                              const LogTimes& times) {
  std::istringstream input(text);
  can_log::LogReader reader(input);
  can_log::LogEntry entry;
  LogCalibration calibration;
  while (reader.next(entry))
    if (usable(entry, times))
      calibration.learn(can_log::to_message(entry.frame), file, static_cast<size_t>(reader.line()));
  if (!calibration.any_sensor_frame())
    throw DataFileError(file, 0, "no sensor frame, expected a candump log that holds the samples (frames sensor_...)");
  calibration.lay_out_pairs(file, model);
  return calibration;
}

void append(const firmware::RawSample& sample, const std::vector<LogChannel>& channels, Record& record) {
  for (size_t i = 0; i < channels.size(); ++i) {
    const int32_t code = sample.code[channels[i].node][channels[i].quantity];
    record.channels[i].values.push_back(static_cast<double>(code - channels[i].offset_code) *
                                        channels[i].unit_per_code);
  }
}

// Throws where samples are lost and nobody asks for interpolation, or their numbers fall.
void require_gap_that_can_be_filled(uint32_t before, uint32_t after, const ReadingOptions& options,
                                    const std::string& file, size_t line) {
  if (after > before && options.resample_Hz > 0.0) return;
  throw DataFileError(file, line,
                      "sample " + std::to_string(after) + " follows sample " + std::to_string(before) + ", expected " +
                          std::to_string(before + 1) + " with all its frames" +
                          (after > before ? "; --resample with the sampling rate interpolates" : ""));
}

// The channels that are calibrated, without those that the user wants left out.
std::vector<LogChannel> wanted_channels(const LogCalibration& calibration, const ColumnContext& context) {
  std::vector<LogChannel> channels = calibration.channels(context.file, context.model);
  channels.erase(std::remove_if(channels.begin(), channels.end(),
                                [&](const LogChannel& channel) {
                                  return is_left_out(*rig_file::parse_channel_name(channel.name), context.options);
                                }),
                 channels.end());
  if (channels.empty()) context.refuse("no channel is left, expected fewer --column CHANNEL=");
  return channels;
}

// Samples are counted on the board: their times are even, whatever was lost.
void keep_gaps(const std::vector<uint32_t>& sequence, Record& record) {
  for (const uint32_t number : sequence)
    record.time_s.push_back(static_cast<double>(number - sequence.front()) * record.sample_period_s);
  const size_t lost = sequence.back() - sequence.front() + 1 - sequence.size();
  record.notes.push_back(std::to_string(lost) + (lost == 1 ? " sample was" : " samples were") + " lost on the bus");
}

void set_period(const SampleNumbers& samples, const ReadingOptions& options, const std::string& file, Record& record) {
  if (options.sample_rate_Hz > 0.0) {
    record.sample_period_s = 1.0 / options.sample_rate_Hz;
    return;
  }
  if (samples.last_ns() <= samples.first_ns())
    throw DataFileError(file, 0,
                        "the times of the frames do not rise, expected times as candump -L writes them, or "
                        "--sample-rate");
  record.sample_period_s = 1e-9 * static_cast<double>(samples.last_ns() - samples.first_ns()) /
                           static_cast<double>(samples.numbers().back() - samples.numbers().front());
}

}  // namespace

bool is_sensor_log(const std::string& path, std::string_view content) {
  if (has_extension(path, ".log") || has_extension(path, ".candump")) return true;
  if (can_log::is_asc_log(content)) return true;
  can_log::LogEntry entry;
  return can_log::parse_line(content.substr(0, content.find_first_of("\r\n")), entry);
}

Record parse_sensor_log(std::string_view content, const std::string& file, const rig_file::RigModel& model,
                        const ReadingOptions& options) {
  const ColumnContext context{model, options, file, 0};
  require_channel_options(
      context,
      "the calibration of a CAN log gives SI units, expected unit_per_code of the [[channel]] in the rig file");
  const std::string text(content);
  const LogTimes times = times_of(text);
  const LogCalibration calibration = calibration_of(text, file, model, times);
  times.require(file, options.sample_rate_Hz);
  const std::vector<LogChannel> channels = wanted_channels(calibration, context);
  Record record;
  record.file = file;
  for (const LogChannel& channel : channels) record.channels.push_back(channel_of_name(channel.name, model, file, 0));

  std::istringstream input(text);
  can_log::LogReader reader(input);
  can_log::LogEntry entry;
  firmware::SensorAssembler assembler(calibration.plan());
  firmware::RawSample sample;
  SampleNumbers samples;
  uint64_t frame_ns = 0;
  while (reader.next(entry)) {
    if (!usable(entry, times)) continue;
    if (!times.tell()) entry.frame.time_ns = 0;  // the samples' numbers alone say how they follow each other
    if (samples.is_pause(std::exchange(frame_ns, entry.frame.time_ns), entry.frame.time_ns))
      assembler = firmware::SensorAssembler(calibration.plan());
    if (!assembler.push(can_log::to_message(entry.frame), entry.frame.time_ns, sample)) continue;
    const uint32_t before = samples.numbers().empty() ? 0 : samples.numbers().back();
    const uint32_t number = samples.take(sample.sequence, sample.time_ns);
    if (samples.numbers().size() > 1 && number != before + 1)
      require_gap_that_can_be_filled(before, number, options, file, static_cast<size_t>(reader.line()));
    append(sample, channels, record);
  }
  if (record.samples() < 2)
    throw DataFileError(file, 0, std::to_string(record.samples()) + " whole samples, expected at least 2");
  set_period(samples, options, file, record);
  const std::vector<uint32_t>& numbers = samples.numbers();
  if (numbers.back() - numbers.front() + 1 != numbers.size()) keep_gaps(numbers, record);
  return record;
}

}  // namespace host_sim
