#include "host_sim/ingestion/mat/mat_variables.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/ingestion/mat/mat_values.hpp"
#include "host_sim/records/columns/head_hints.hpp"
#include "host_sim/records/columns/names/column_name.hpp"

namespace host_sim::mat {
namespace {

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

// The field of that name; nullptr: there is none.
matvar_t* field_of(matvar_t& variable, const std::string& wanted, size_t element, const Source& source) {
  char* const* const names = source.library.field_names(&variable);
  for (unsigned i = 0; i < source.library.field_count(&variable); ++i)
    if (names[i] == wanted) return source.library.field(&variable, i, element);
  return nullptr;
}

// As Simulink logs a signal: "structure with time", or without.
bool is_logged(matvar_t& variable, const Source& source) {
  if (element_count(variable) != 1 || field_of(variable, "time", 0, source) == nullptr) return false;
  matvar_t* const signals = field_of(variable, "signals", 0, source);
  return signals != nullptr && signals->class_type == MAT_C_STRUCT && element_count(*signals) > 0 &&
         field_of(*signals, "values", 0, source) != nullptr;
}

// The times of what was logged, where there are some: all variables of a record have the same.
void collect_times(const std::string& name, const matvar_t& time, const Source& source, Group& group) {
  if (!numeric(time) || time.data == nullptr || element_count(time) == 0) return;
  const std::vector<double> times = real_values(source.file, name + ".time", time);
  check_finite(source.file, name + ".time", times);
  for (size_t i = 0; i < group.names.size(); ++i) {
    if (group.names[i].head != "t_s") continue;
    if (group.values[i] != times)
      fail(source.file, name, "logged at other times than what stands before it, expected one sample time for all");
    return;
  }
  group.names.push_back({"t_s", ""});
  group.values.push_back(times);
}

// Its signal has the variable's name, several are "NAME signal 1" and so on.
void collect_logged(const std::string& name, matvar_t& variable, const Source& source, Group& group) {
  collect_times(name, *field_of(variable, "time", 0, source), source, group);
  matvar_t& signals = *field_of(variable, "signals", 0, source);
  const size_t count = element_count(signals);
  for (size_t i = 0; i < count; ++i) {
    const matvar_t* const values = field_of(signals, "values", i, source);
    if (values != nullptr)
      collect(count > 1 ? name + " signal " + std::to_string(i + 1) : name, *values, source, group);
  }
}

}  // namespace

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

void collect_struct(const std::string& name, matvar_t& variable, const Source& source, std::vector<Group>& groups) {
  if (is_logged(variable, source)) return collect_logged(name, variable, source, groups.front());
  const unsigned fields = source.library.field_count(&variable);
  char* const* const names = source.library.field_names(&variable);
  const size_t count = element_count(variable);
  for (size_t element = 0; element < count; ++element) {
    Group group;
    group.label = name + (count > 1 ? "(" + std::to_string(element + 1) + ")" : std::string());
    const std::string label = group.label;
    for (unsigned i = 0; i < fields; ++i) {
      matvar_t* const field = source.library.field(&variable, i, element);
      if (field == nullptr) continue;
      if (field->class_type == MAT_C_STRUCT)
        collect_struct(label + "." + names[i], *field, source, groups);
      else
        collect(names[i], *field, source, group);
    }
    groups.push_back(std::move(group));
  }
}

}  // namespace host_sim::mat
