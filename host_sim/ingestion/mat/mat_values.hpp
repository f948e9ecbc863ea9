// The numbers of a variable of a MAT file.
#pragma once
#include <matio.h>

#include <string>
#include <vector>

namespace host_sim::mat {

// DataFileError about one variable of a file.
[[noreturn]] void fail(const std::string& file, const std::string& variable, const std::string& problem);

bool numeric(const matvar_t& variable);
size_t element_count(const matvar_t& variable);
// Of a numeric one, as they lie: column by column.
std::vector<double> real_values(const std::string& file, const std::string& name, const matvar_t& variable);

}  // namespace host_sim::mat
