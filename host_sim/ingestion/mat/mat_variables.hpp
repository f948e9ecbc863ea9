// Which variables of a MAT file are channels, and of which record.
#pragma once
#include <string>
#include <vector>

#include "host_sim/ingestion/mat/mat_library.hpp"
#include "host_sim/records/columns/column_meaning.hpp"

namespace host_sim::mat {

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
  const MatLibrary& library;
};

// A variable of the top or of a struct, into that record: a vector, or a matrix of several channels side by side.
void collect(const std::string& name, const matvar_t& variable, const Source& source, Group& group);
// Each element of a struct is a record, and so are structs within it. But a signal of Simulink ("structure with time": fields time and
// signals) is a variable of the record at the top, as is every other one that was logged beside it.
void collect_struct(const std::string& name, matvar_t& variable, const Source& source, std::vector<Group>& groups);

}  // namespace host_sim::mat
