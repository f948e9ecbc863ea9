// The options of every command that reads measured data, and the reading.
#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/data_check/data_check.hpp"
#include "host_sim/records/record.hpp"
#include "host_sim/records/times/time_span.hpp"

namespace host_sim {

struct DataArguments {
  std::vector<std::string> columns, units, sensitivities;  // "acceleration_1=Chan 3"
  double sample_rate_Hz = 0.0, resample_Hz = 0.0;
  TimeSpan span;                    // --from, --to
  bool in_spite_of_faults = false;  // --anyway
};

// --column, --unit, --sensitivity, --sample-rate, --resample, --from, --to
void add_data_options(CLI::App& command, DataArguments& arguments);
// --anyway, of the commands that compute with the data.
void add_anyway_option(CLI::App& command, DataArguments& arguments);

// All records of all files, in their order. What the reader made of them (factors, ignored columns) goes to stderr, one
// line each; what is said of several files alike is said once, with all their names. Throws DataFileError, UsageError.
// A file that is given twice is told.
std::vector<Record> read_data(const std::vector<std::string>& paths, const rig_file::RigModel& model,
                              const DataArguments& arguments);

// No file of --holdout is one of --data: UsageError.
void require_unseen(const std::vector<std::string>& data, const std::vector<std::string>& holdout);

// The check of the data before anything is computed: doubts go to stderr; a fault throws CannotAnswer, or goes to stderr
// too where the user wants the numbers anyway. Returns all that was found.
data_check::Report require_sound(const std::vector<Record>& records, const rig_file::RigModel& model,
                                 const DataArguments& arguments);
// The same of a check that has been made.
void require_sound(const data_check::Report& report, const DataArguments& arguments);

// Lines below each other, indented under the first.
std::string joined_lines(const std::vector<std::string>& lines);

}  // namespace host_sim
