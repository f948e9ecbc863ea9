// A table of text as it is read: how it is laid out, where its columns go, and what has come in so far.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/records/csv/layout/csv_layout.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// Where the values of a column go.
struct Target {
  std::vector<double>* values = nullptr;  // nullptr: ignored
  double factor = 1.0;
  std::string name;
};

// A line of the data.
struct Row {
  size_t line = 1;
  std::string_view text;
};

struct CsvTable {
  CsvTable() = default;
  CsvTable(const CsvTable&) = delete;  // the targets point into it
  CsvTable& operator=(const CsvTable&) = delete;

  std::string_view content;
  CsvLayout layout;
  double rate_Hz = 0.0;         // that is told in place of times; 0: it is not
  std::vector<Target> targets;  // one for each column
  size_t needed = 0;            // so many of them, to the last that is not ignored

  Record record;
  std::vector<double> time_s;
  size_t samples = 0;

  std::vector<size_t> comments;  // how many samples stood before each comment line among the rows
  std::vector<size_t> repeats;   // samples whose row is the one before, word by word
  size_t left_out = 0;           // rows before the first sample
  std::vector<size_t> row_of;    // each sample's, from 0 at the first, once some between were left out; else empty
  bool lacks_times = false;      // in some rows
  std::string blank;             // the last field without a value: "" or "NaN"

  // The row's text and all that follows it.
  std::string_view from(std::string_view row) const;
  // Where a sample stands in the file.
  size_t line_of(size_t sample) const;
  // Whether the row holds the names of the columns.
  bool is_header(std::string_view row) const;
  [[noreturn]] void refuse(size_t line, const std::string& problem) const;

  // The samples from first to end, and those that are kept, of all channels and of the times.
  void keep_samples(size_t first, size_t end);
  void keep_samples(const std::vector<bool>& keep);
};

}  // namespace host_sim
