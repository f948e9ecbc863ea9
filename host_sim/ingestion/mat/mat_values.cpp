#include "host_sim/ingestion/mat/mat_values.hpp"

#include "host_sim/records/files/data_file_error.hpp"

namespace host_sim::mat {

void fail(const std::string& file, const std::string& variable, const std::string& problem) {
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

namespace {

template <typename T>
std::vector<double> converted(const void* data, size_t count) {
  const T* values = static_cast<const T*>(data);
  std::vector<double> out(count);
  for (size_t i = 0; i < count; ++i) out[i] = static_cast<double>(values[i]);
  return out;
}

}  // namespace

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

}  // namespace host_sim::mat
