#include "host_sim/ingestion/mat_reader.hpp"

#include <matio.h>

#include <cmath>
#include <memory>

#include "host_sim/records/data_file_error.hpp"
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

// What a MAT file gives, before it is checked as a whole.
struct Collected {
  std::string file;
  const rig_file::RigModel& model;
  Record record;
  std::vector<double> time_s;
  double sample_rate_Hz = 0.0;
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

void collect(const matvar_t& variable, Collected& into) {
  const std::string name = variable.name == nullptr ? "" : variable.name;
  if (!numeric(variable) || variable.data == nullptr) return;  // text, cells, empty matrices
  if (name == "sample_rate_Hz") {
    const std::vector<double> value = real_values(into.file, name, variable);
    if (value.size() != 1 || !std::isfinite(value[0]) || !(value[0] > 0.0))
      fail(into.file, name, "expected one number above 0");
    into.sample_rate_Hz = value[0];
    return;
  }
  if (name != "t_s" && element_count(variable) == 1) return;
  check_vector(into.file, name, variable);
  std::vector<double> values = real_values(into.file, name, variable);
  check_finite(into.file, name, values);
  if (name == "t_s") {
    into.time_s = std::move(values);
    return;
  }
  Channel channel = channel_of_name(name, into.model, into.file, 0);
  if (into.record.find(channel.quantity, channel.dof) != nullptr)
    fail(into.file, name, "for the second time, expected each channel once");
  channel.values = std::move(values);
  into.record.channels.push_back(std::move(channel));
}

void collect_struct(matvar_t& variable, Collected& into) {
  if (element_count(variable) != 1)
    fail(into.file, variable.name, "an array of structs, expected one struct (one file per record)");
  const unsigned fields = Mat_VarGetNumberOfFields(&variable);
  char* const* const names = Mat_VarGetStructFieldnames(&variable);
  for (unsigned i = 0; i < fields; ++i) {
    matvar_t* const field = Mat_VarGetStructFieldByIndex(&variable, i, 0);
    if (field == nullptr) continue;
    char* const kept = field->name;  // fields of some files carry no name of their own
    field->name = names[i];
    try {
      collect(*field, into);
    } catch (...) {
      field->name = kept;
      throw;
    }
    field->name = kept;
  }
}

void finish(Collected& collected) {
  Record& record = collected.record;
  record.file = collected.file;
  if (record.channels.empty())
    throw DataFileError(collected.file, 0, "no channel, expected variables such as force_1_N and displacement_1_m");
  for (const Channel& channel : record.channels)
    if (channel.values.size() != record.samples())
      fail(collected.file, channel.name,
           std::to_string(channel.values.size()) + " values, expected " + std::to_string(record.samples()) + " as in " +
               record.channels.front().name);
  if (!collected.time_s.empty()) {
    if (collected.time_s.size() != record.samples())
      fail(collected.file, "t_s",
           std::to_string(collected.time_s.size()) + " values, expected " + std::to_string(record.samples()) +
               " as in " + record.channels.front().name);
    try {
      set_time_base(collected.time_s, 0, record);
    } catch (const DataFileError& error) {  // its line is the element of t_s
      throw DataFileError(collected.file, 0, "element " + std::to_string(error.line + 1) + " of " + error.problem);
    }
  } else if (collected.sample_rate_Hz > 0.0) {
    record.sample_period_s = 1.0 / collected.sample_rate_Hz;
  } else {
    throw DataFileError(collected.file, 0, "no time, expected a variable t_s or sample_rate_Hz");
  }
}

}  // namespace

bool is_mat(const std::string& path, std::string_view content) {
  const bool extension = path.size() > 4 && (path.compare(path.size() - 4, 4, ".mat") == 0 ||
                                             path.compare(path.size() - 4, 4, ".MAT") == 0);
  return extension || content.substr(0, 7) == "MATLAB ";
}

Record read_mat(const std::string& path, const rig_file::RigModel& model) {
  Mat_LogInitFunc(nullptr, [](int, char*) {});  // the library's own messages say less than ours
  const File file(Mat_Open(path.c_str(), MAT_ACC_RDONLY), Mat_Close);
  if (!file) throw DataFileError(path, 0, "is no MAT file that can be read, expected version 4, 5 or 7.3");
  Collected collected{path, model, {}, {}, 0.0};
  for (;;) {
    const Variable variable(Mat_VarReadNext(file.get()), Mat_VarFree);
    if (!variable) break;
    if (variable->class_type == MAT_C_STRUCT) {
      collect_struct(*variable, collected);
    } else {
      collect(*variable, collected);
    }
  }
  finish(collected);
  return std::move(collected.record);
}

}  // namespace host_sim
