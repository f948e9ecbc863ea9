#include "host_sim/ingestion/mat/mat_reader.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

#include "host_sim/ingestion/mat/mat_end.hpp"
#include "host_sim/ingestion/mat/mat_library.hpp"
#include "host_sim/ingestion/mat/mat_sizes.hpp"
#include "host_sim/ingestion/mat/mat_values.hpp"
#include "host_sim/ingestion/mat/mat_variables.hpp"
#include "host_sim/records/columns/column_meaning.hpp"
#include "host_sim/records/columns/head_hints.hpp"
#include "host_sim/records/columns/names/column_name.hpp"
#include "host_sim/records/files/data_file_error.hpp"
#include "host_sim/records/files/file_content.hpp"
#include "host_sim/records/files/file_extension.hpp"
#include "host_sim/records/record_checks.hpp"

namespace host_sim {
namespace {

using mat::fail;
using mat::Group;
using mat::Source;

using File = std::unique_ptr<mat_t, int (*)(mat_t*)>;
using Variable = std::unique_ptr<matvar_t, void (*)(matvar_t*)>;

void set_time(const Group& group, const std::vector<double>& time_s, const Source& source, Record& record) {
  if (!time_s.empty() && source.options.sample_rate_Hz <= 0.0) {
    if (time_s.size() != record.samples())
      fail(source.file, "t_s",
           std::to_string(time_s.size()) + " values, expected " + std::to_string(record.samples()) + " as in " +
               record.channels.front().name);
    try {
      const auto set = source.options.resample_Hz > 0.0 ? keep_times : set_time_base;
      set(
          time_s, [](size_t sample) { return sample; }, record);
    } catch (const DataFileError& error) {  // its line is the element of t_s
      throw DataFileError(source.file, 0, "element " + std::to_string(error.line + 1) + " of " + error.problem);
    }
    return;
  }
  const double rate_Hz = source.options.sample_rate_Hz > 0.0 ? source.options.sample_rate_Hz : group.sample_rate_Hz;
  if (!(rate_Hz > 0.0))
    throw DataFileError(source.file, 0, "no time, expected a variable t_s or sample_rate_Hz, or --sample-rate");
  record.sample_period_s = 1.0 / rate_Hz;
}

// What a file holds beside plain arrays, and what to do about it; empty where it holds no object.
std::string of_objects(const std::vector<Group>& groups) {
  std::string names;
  bool any = false;
  for (const Group& group : groups)
    for (const std::string& name : group.objects) {
      any = true;
      if (!name.empty()) names += " \"" + name + "\"";
    }
  if (!any) return "";
  return "holds an object of a MATLAB class" + names +
         " (such as a timetable or a Simulink.SimulationOutput), whose layout is MATLAB's own; expected plain arrays "
         "of "
         "numbers: in MATLAB save the arrays in it, or write a table with writetable or writetimetable";
}

[[noreturn]] void refuse_without_channels(const std::vector<Group>& groups, const Source& source) {
  std::string names;
  for (const Group& group : groups)
    for (const Column& name : group.names) names += (names.empty() ? "" : ", ") + ("\"" + name.head + "\"");
  const std::string objects = of_objects(groups);
  if (!objects.empty() && names.empty()) throw DataFileError(source.file, 0, objects);
  const bool rotates = !source.model.dofs.empty() && source.model.dofs[0].rotating;
  throw DataFileError(source.file, 0,
                      "no channel" + (names.empty() ? "" : " among the variables " + names) +
                          ", expected variables such as " +
                          (rotates ? "torque_1_N_m and angle_1_rad, or --column angle_1=NAME"
                                   : "force_1_N and displacement_1_m, or --column displacement_1=NAME") +
                          " for a variable with a name of its own" + (objects.empty() ? "" : "; the file " + objects));
}

void to_si(const std::string& name, double factor, const Source& source, std::vector<double>& values) {
  for (size_t i = 0; i < values.size(); ++i) {
    values[i] *= factor;
    if (!std::isfinite(values[i]))
      fail(source.file, name,
           "element " + std::to_string(i + 1) + " is too large in SI units, expected a measured value: check the unit");
  }
}

Record record_of(Group& group, const Source& source) {
  Record record;
  record.file = source.file + (group.label.empty() ? "" : ", " + group.label);
  ColumnPlan plan = plan_columns(group.names, source.model, source.options, source.file, 0);
  record.notes = plan.notes;
  std::vector<double> time_s;
  for (size_t i = 0; i < plan.uses.size(); ++i) {
    ColumnUse& use = plan.uses[i];
    to_si(group.names[i].head, use.factor, source, group.values[i]);
    if (use.kind == ColumnUse::Kind::kTime) time_s = std::move(group.values[i]);
    if (use.kind != ColumnUse::Kind::kChannel) continue;
    record.channels.push_back(std::move(use.channel));
    record.channels.back().values = std::move(group.values[i]);
  }
  if (record.channels.empty()) refuse_without_channels({group}, source);
  for (const Channel& channel : record.channels)
    if (channel.values.size() != record.samples())
      fail(source.file, channel.name,
           std::to_string(channel.values.size()) + " values, expected " + std::to_string(record.samples()) + " as in " +
               record.channels.front().name);
  set_time(group, time_s, source, record);
  return record;
}

bool any_channel(const Group& group) {
  for (size_t i = 0; i < group.names.size(); ++i)
    if (!group.values[i].empty() && group.names[i].head != "t_s") return true;
  return false;
}

}  // namespace

bool is_mat(const std::string& path, std::string_view content) {
  return has_extension(path, ".mat") || content.substr(0, 7) == "MATLAB ";
}

std::vector<Record> read_mat(const std::string& path, const rig_file::RigModel& model, const ReadingOptions& options) {
  static std::mutex one_at_a_time;  // the library beneath (HDF5) is not for several threads
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  const MatLibrary* const library = mat_library();
  if (library == nullptr) throw DataFileError(path, 0, kNoMatLibrary);
  library->log_to(nullptr, [](int, char*) {});  // the library's own messages say less than ours
  const File file(library->open(path.c_str(), MAT_ACC_RDONLY), library->close);
  if (!file) throw DataFileError(path, 0, "is no MAT file that can be read, expected version 4, 5 or 7.3");
  if (const uint64_t missing = missing_mat_bytes(path))
    throw DataFileError(path, 0,
                        "ends early, " + std::to_string(missing) + " bytes are missing: copy it from its source again");
  require_sizes_of_mat(FileContent(path).text(), path, *library);
  const Source source{path, model, options, *library};
  std::vector<Group> groups(1);
  for (;;) {
    const Variable variable(library->read_next(file.get()), library->free);
    if (!variable) break;
    const std::string name = variable->name == nullptr ? "" : variable->name;
    if (variable->class_type == MAT_C_STRUCT) {
      mat::collect_struct(name, *variable, source, groups);
    } else {
      mat::collect(name, *variable, source, groups.front());
    }
  }
  std::vector<Record> records;
  for (Group& group : groups) {
    if (!any_channel(group) && groups.size() > 1) continue;  // beside structs, what stands at the top may be anything
    if (group.sample_rate_Hz <= 0.0) group.sample_rate_Hz = groups.front().sample_rate_Hz;
    records.push_back(record_of(group, source));
  }
  if (records.empty()) refuse_without_channels(groups, source);
  return records;
}

}  // namespace host_sim
