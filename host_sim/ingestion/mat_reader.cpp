#include "host_sim/ingestion/mat_reader.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

#include "host_sim/ingestion/mat_end.hpp"
#include "host_sim/ingestion/mat_library.hpp"
#include "host_sim/records/columns/column_meaning.hpp"
#include "host_sim/records/columns/head_hints.hpp"
#include "host_sim/records/columns/names/column_name.hpp"
#include "host_sim/records/files/data_file_error.hpp"
#include "host_sim/records/record_checks.hpp"

namespace host_sim {
namespace {

using File = std::unique_ptr<mat_t, int (*)(mat_t*)>;
using Variable = std::unique_ptr<matvar_t, void (*)(matvar_t*)>;

[[noreturn]] void fail(const std::string& file, const std::string& variable, const std::string& problem) {
  throw DataFileError(file, 0, "variable \"" + variable + "\": " + problem);
}

bool numeric(const matvar_t& variable) {
  switch (variable.class_type) {
    case MAT_C_DOUBLE:
    case MAT_C_SINGLE:
    case MAT_C_INT8:
    case MAT_C_UINT8:
    case MAT_C_INT16:
    case MAT_C_UINT16:
    case MAT_C_INT32:
    case MAT_C_UINT32:
    case MAT_C_INT64:
    case MAT_C_UINT64:
      return true;
    default:
      return false;
  }
}

size_t element_count(const matvar_t& variable) {
  size_t count = 1;
  for (int i = 0; i < variable.rank; ++i) count *= variable.dims[i];
  return count;
}

template <typename T>
std::vector<double> converted(const void* data, size_t count) {
  const T* values = static_cast<const T*>(data);
  std::vector<double> out(count);
  for (size_t i = 0; i < count; ++i) out[i] = static_cast<double>(values[i]);
  return out;
}

std::vector<double> real_values(const std::string& file, const std::string& name, const matvar_t& variable) {
  if (variable.isComplex) fail(file, name, "complex numbers, expected real ones");
  const size_t count = element_count(variable);
  switch (variable.data_type) {
    case MAT_T_DOUBLE:
      return converted<double>(variable.data, count);
    case MAT_T_SINGLE:
      return converted<float>(variable.data, count);
    case MAT_T_INT8:
      return converted<int8_t>(variable.data, count);
    case MAT_T_UINT8:
      return converted<uint8_t>(variable.data, count);
    case MAT_T_INT16:
      return converted<int16_t>(variable.data, count);
    case MAT_T_UINT16:
      return converted<uint16_t>(variable.data, count);
    case MAT_T_INT32:
      return converted<int32_t>(variable.data, count);
    case MAT_T_UINT32:
      return converted<uint32_t>(variable.data, count);
    case MAT_T_INT64:
      return converted<int64_t>(variable.data, count);
    case MAT_T_UINT64:
      return converted<uint64_t>(variable.data, count);
    default:
      fail(file, name, "a number format that is not known, expected double precision");
  }
}

// The variables of one record: the top of the file or one struct.
struct Group {
  std::string label;  // of the struct; empty at the top
  std::vector<Column> names;
  std::vector<std::vector<double>> values;  // empty where the variable is ignored
  double sample_rate_Hz = 0.0;
  std::vector<std::string> objects;  // of MATLAB's classes, which no other program reads: their names
};

struct Source {
  const std::string& file;
  const rig_file::RigModel& model;
  const ReadingOptions& options;
  const MatLibrary& mat;
};

void check_vector(const std::string& file, const std::string& name, const matvar_t& variable) {
  if (variable.rank != 2 || (variable.dims[0] != 1 && variable.dims[1] != 1))
    fail(file, name, "not a vector, expected a row or a column of numbers");
}

void check_finite(const std::string& file, const std::string& name, const std::vector<double>& values) {
  for (size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      fail(file, name, "element " + std::to_string(i + 1) + " is not a finite number, expected measured values");
}

bool is_sample_rate(const std::string& name) {
  return name == "sample_rate_Hz" || name == "sample_rate" || name == "fs" || name == "Fs" || name == "fs_Hz";
}

// Several channels side by side, in the rows or the columns of a matrix: many samples of a few.
constexpr size_t kMostChannels = 64;
bool is_table(const matvar_t& variable) {
  if (variable.rank != 2) return false;
  const size_t few = std::min(variable.dims[0], variable.dims[1]), many = std::max(variable.dims[0], variable.dims[1]);
  return few > 1 && few <= kMostChannels && many >= 4 * few;
}

// Its channels are "NAME row 1" or "NAME column 1" and so on, for --column.
void collect_table(const std::string& name, const matvar_t& variable, const Source& source, Group& group) {
  const size_t rows = variable.dims[0], columns = variable.dims[1], channels = std::min(rows, columns);
  const bool in_rows = rows < columns;
  for (size_t i = 0; i < channels; ++i) {
    const std::string head = name + (in_rows ? " row " : " column ") + std::to_string(i + 1);
    group.names.push_back({head, ""});
    group.values.emplace_back();
    if (!means_channel(head, source.model, source.options)) continue;
    const std::vector<double> all = real_values(source.file, name, variable);  // column by column
    for (size_t k = 0; k < std::max(rows, columns); ++k)
      group.values.back().push_back(all[in_rows ? k * rows + i : i * rows + k]);
    check_finite(source.file, head, group.values.back());
  }
}

// A timetable, a Simulink.SimulationOutput, a string. The library beneath may tell no name of it.
bool is_object(const matvar_t& variable) {
  return variable.class_type == MAT_C_OPAQUE || variable.class_type == MAT_C_OBJECT;
}

void collect(const std::string& name, const matvar_t& variable, const Source& source, Group& group) {
  if (is_object(variable)) return group.objects.push_back(name);
  if (name.empty()) return;                                    // where MATLAB keeps what is in its objects
  if (!numeric(variable) || variable.data == nullptr) return;  // text, cells, empty matrices
  if (is_sample_rate(name)) {
    const std::vector<double> value = real_values(source.file, name, variable);
    if (value.size() != 1 || !std::isfinite(value[0]) || !(value[0] > 0.0))
      fail(source.file, name, "expected one number above 0");
    group.sample_rate_Hz = value[0];
    return;
  }
  std::string suffix;
  const bool wanted = means_channel(name, source.model, source.options) || is_time_name(name, suffix);
  if (element_count(variable) == 1 && name != "t_s") return;
  if (!wanted && is_table(variable)) return collect_table(name, variable, source, group);
  group.names.push_back({name, ""});
  group.values.emplace_back();
  if (!wanted) return;
  check_vector(source.file, name, variable);
  group.values.back() = real_values(source.file, name, variable);
  check_finite(source.file, name, group.values.back());
}

// Each element of a struct is a record, and so are structs within it.
void collect_structs(const std::string& name, matvar_t& variable, const Source& source, std::vector<Group>& groups) {
  const unsigned fields = source.mat.field_count(&variable);
  char* const* const names = source.mat.field_names(&variable);
  const size_t count = element_count(variable);
  for (size_t element = 0; element < count; ++element) {
    Group group;
    group.label = name + (count > 1 ? "(" + std::to_string(element + 1) + ")" : std::string());
    const std::string label = group.label;
    for (unsigned i = 0; i < fields; ++i) {
      matvar_t* const field = source.mat.field(&variable, i, element);
      if (field == nullptr) continue;
      if (field->class_type == MAT_C_STRUCT)
        collect_structs(label + "." + names[i], *field, source, groups);
      else
        collect(names[i], *field, source, group);
    }
    groups.push_back(std::move(group));
  }
}

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

Record record_of(Group& group, const Source& source) {
  Record record;
  record.file = source.file + (group.label.empty() ? "" : ", " + group.label);
  ColumnPlan plan = plan_columns(group.names, source.model, source.options, source.file, 0);
  record.notes = plan.notes;
  std::vector<double> time_s;
  for (size_t i = 0; i < plan.uses.size(); ++i) {
    ColumnUse& use = plan.uses[i];
    for (double& value : group.values[i]) value *= use.factor;
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
  const bool extension = path.size() > 4 && (path.compare(path.size() - 4, 4, ".mat") == 0 ||
                                             path.compare(path.size() - 4, 4, ".MAT") == 0);
  return extension || content.substr(0, 7) == "MATLAB ";
}

std::vector<Record> read_mat(const std::string& path, const rig_file::RigModel& model, const ReadingOptions& options) {
  static std::mutex one_at_a_time;  // the library beneath (HDF5) is not for several threads
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  const MatLibrary* const mat = mat_library();
  if (mat == nullptr) throw DataFileError(path, 0, kNoMatLibrary);
  mat->log_to(nullptr, [](int, char*) {});  // the library's own messages say less than ours
  const File file(mat->open(path.c_str(), MAT_ACC_RDONLY), mat->close);
  if (!file) throw DataFileError(path, 0, "is no MAT file that can be read, expected version 4, 5 or 7.3");
  if (const uint64_t missing = missing_mat_bytes(path))
    throw DataFileError(path, 0,
                        "ends early, " + std::to_string(missing) + " bytes are missing: copy it from its source again");
  const Source source{path, model, options, *mat};
  std::vector<Group> groups(1);
  for (;;) {
    const Variable variable(mat->read_next(file.get()), mat->free);
    if (!variable) break;
    if (variable->class_type == MAT_C_STRUCT) {
      collect_structs(variable->name, *variable, source, groups);
    } else {
      collect(variable->name == nullptr ? "" : variable->name, *variable, source, groups.front());
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
