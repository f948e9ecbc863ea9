#include "host_sim/programs/shared/data_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <future>
#include <stdexcept>

#include "host_sim/data_check/report/to_json.hpp"
#include "host_sim/ingestion/record_reader.hpp"
#include "host_sim/programs/shared/above_nought.hpp"
#include "host_sim/programs/shared/failures.hpp"
#include "host_sim/records/ac_coupling.hpp"
#include "host_sim/records/derived/computed_anywhere.hpp"
#include "host_sim/records/record_checks.hpp"
#include "host_sim/records/times/no_finer.hpp"

namespace host_sim {
namespace {

ReadingOptions::Choices choices(const char* option, const std::vector<std::string>& texts) {
  ReadingOptions::Choices result;
  for (const std::string& text : texts) {
    if (std::string(option) == "--column" && text.size() > 1 && text.back() == '=') {  // a channel left out
      result.push_back({text.substr(0, text.size() - 1), ""});
      continue;
    }
    try {
      result.push_back(parse_choice(text));
    } catch (const std::invalid_argument& error) {
      throw UsageError(std::string(option) + " " + error.what());
    }
  }
  return result;
}

CLI::Validator seconds() {
  return CLI::Validator(
      [](const std::string& text) {
        double number = 0.0;
        const bool is_number = CLI::detail::lexical_cast(text, number) && !std::isnan(number);
        return is_number ? std::string() : "is \"" + text + "\", expected a number of seconds";
      },
      "SECONDS");
}

}  // namespace

void add_data_options(CLI::App& command, DataArguments& arguments) {
  command.add_option(
      "--column", arguments.columns,
      "CHANNEL=NAME: the data file's column of that name is this channel (CHANNEL= leaves the channel out); may be "
      "repeated");
  command.add_option("--unit", arguments.units, "CHANNEL=UNIT: the unit that column is in; may be repeated");
  command.add_option("--sensitivity", arguments.sensitivities,
                     "CHANNEL=VALUE: of a sensor whose column is a voltage, as in acceleration_1=\"100 mV/g\"");
  command
      .add_option("--sample-rate", arguments.sample_rate_Hz,
                  "samples per second, for files without a column of time (or with one that is not to be believed)")
      ->check(above_nought());
  command
      .add_option("--resample", arguments.resample_Hz,
                  "samples per second onto which records of uneven times are interpolated; gaps part a record")
      ->check(above_nought());
  command
      .add_option("--from", arguments.span.from_s,
                  "seconds of the file's own time: what every record holds before them is left out")
      ->check(seconds());
  command.add_option("--to", arguments.span.to_s, "the same of what it holds after them")->check(seconds());
}

void add_anyway_option(CLI::App& command, DataArguments& arguments) {
  command.add_flag("--anyway", arguments.in_spite_of_faults,
                   "compute in spite of what the check of the data finds (see host_sim check)");
}

namespace {

bool same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return std::filesystem::equivalent(a, b, ignored);
}

// Its intervals are narrower than one measurement's, and no righter.
void tell_twice(const std::vector<std::string>& paths) {
  for (auto path = paths.begin(); path != paths.end(); ++path) {
    const auto same = [&](const std::string& other) { return same_file(other, *path); };
    if (std::any_of(path + 1, paths.end(), same)) continue;  // it is told where it stands last
    const auto before = std::count_if(paths.begin(), path, same);
    if (before == 0) continue;
    const std::string times =
        before == 1 ? "twice and counts as two" : fmt::format("{0} times and counts as {0}", before + 1);
    std::fprintf(stderr, "%s: is given %s measurements: the intervals are too narrow\n", path->c_str(), times.c_str());
  }
}

// What is said of the files; they are said when it goes, also where another file could not be read. Several files may have the same
// note: it names them all. The records of a file that share one are told by the first.
class Notes {
 public:
  Notes() = default;
  Notes(const Notes&) = delete;
  Notes& operator=(const Notes&) = delete;
  ~Notes() {
    for (const Note& note : notes_) std::fprintf(stderr, "%s: %s\n", names(note.records).c_str(), note.text.c_str());
  }
  void add(size_t file, const std::string& record, const std::string& text) {
    const auto same = std::find_if(notes_.begin(), notes_.end(), [&](const Note& note) { return note.text == text; });
    if (same == notes_.end()) {
      notes_.push_back({text, file, {record}});
    } else if (same->last_file != file) {
      same->last_file = file;
      same->records.push_back(record);
    }
  }

 private:
  struct Note {
    std::string text;
    size_t last_file;
    std::vector<std::string> records;
  };
  static std::string names(const std::vector<std::string>& records) {
    std::string text = records.front();
    for (size_t i = 1; i < records.size(); ++i) text += (i + 1 == records.size() ? " and " : ", ") + records[i];
    return text;
  }
  std::vector<Note> notes_;
};

}  // namespace

void require_unseen(const std::vector<std::string>& data, const std::vector<std::string>& holdout) {
  for (const std::string& path : holdout)
    for (const std::string& seen : data)
      if (same_file(path, seen))
        throw UsageError("\"" + path +
                         "\" is given to --data and to --holdout: what the fit has seen tells nothing there");
}

std::vector<Record> read_data(const std::vector<std::string>& paths, const rig_file::RigModel& model,
                              const DataArguments& arguments) {
  tell_twice(paths);
  ReadingOptions options;
  options.columns = choices("--column", arguments.columns);
  options.units = choices("--unit", arguments.units);
  options.sensitivities = choices("--sensitivity", arguments.sensitivities);
  options.sample_rate_Hz = arguments.sample_rate_Hz;
  options.resample_Hz = arguments.resample_Hz;
  if (arguments.span.from_s >= arguments.span.to_s) throw UsageError("--from has to lie before --to");
  options.span = arguments.span;
  // Beside each other; what is said of them, and what is wrong with one, comes in their order.
  std::vector<std::future<std::vector<Record>>> files;
  for (const std::string& path : paths)
    files.push_back(std::async(paths.size() > 1 ? std::launch::async : std::launch::deferred,
                               [&path, &model, &options] { return read_records(path, model, options); }));
  std::vector<Record> records;
  Notes notes;
  for (size_t i = 0; i < files.size(); ++i)
    for (Record& record : files[i].get()) {
      for (const std::string& note : record.notes) notes.add(i, record.file, note);
      records.push_back(std::move(record));
    }
  if (arguments.resample_Hz > 0.0) require_no_finer(records, arguments.resample_Hz);
  size_t other = files.size();
  for (const LeftOutToo& column : leave_out_computed_anywhere({&records})) notes.add(other++, column.file, column.note);
  undo_ac_coupling(stated_ac_couplings(model), records);
  if (!records.empty()) order_channels_as(records.front(), records);
  return records;
}

std::string joined_lines(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n  ") + line;
  return text;
}

void require_sound(const data_check::Report& report, const DataArguments& arguments) {
  const bool stop = report.worst() == data_check::Weight::kFault && !arguments.in_spite_of_faults;
  if (stop)
    throw CannotAnswer("the recordings have faults (host_sim check tells more, --anyway computes all the same)\n  " +
                       joined_lines(data_check::lines_of(report, data_check::Weight::kFault)));
  for (const std::string& line : data_check::lines_of(report, data_check::Weight::kDoubt))
    std::fprintf(stderr, "%s\n", line.c_str());
}

data_check::Report require_sound(const std::vector<Record>& records, const rig_file::RigModel& model,
                                 const DataArguments& arguments) {
  data_check::Report report = data_check::check(records, &model);
  require_sound(report, arguments);
  return report;
}

}  // namespace host_sim
