// Values that are missing between others: a sample lost, an outlier taken out, channels of a logger that write by turns.
#pragma once
#include <string>
#include <vector>

#include "host_sim/records/csv/blanks/blank_ends.hpp"

namespace host_sim {

struct FilledBlanks {
  size_t filled = 0;       // values
  size_t left_out = 0;     // rows, in a gap too long to be filled
  std::string names;       // of the columns that lacked any
  std::vector<bool> keep;  // per row
};

// The usual step between the values of the column that has most of them, s; 0 where none has two.
double fastest_step(const std::vector<double>& time_s, const std::vector<TableColumn>& columns);

// Fills each column from its own values: the cubic through the two before and the two behind, over gaps of at most kLongestGap of
// its own usual steps. time_s: of the rows, s, increasing. A row in a longer gap of any column, before its first or behind its last value, is not kept.
FilledBlanks fill_blanks(const std::vector<double>& time_s, const std::vector<TableColumn>& columns);

// Those of the rows that are kept.
template <typename Value>
void keep_only(const std::vector<bool>& keep, std::vector<Value>& values) {
  size_t kept = 0;
  for (size_t row = 0; row < values.size(); ++row)
    if (keep[row]) values[kept++] = values[row];
  values.resize(kept);
}

}  // namespace host_sim
