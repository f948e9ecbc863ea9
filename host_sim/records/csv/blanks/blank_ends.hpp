// Rows at the ends of a table in which a channel has no value: what a program derives (a velocity, an acceleration, a filtered
// signal) begins later and ends earlier than what it measures.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace host_sim {

struct TableColumn {
  std::string name;
  std::vector<double>* values;  // NaN: no value
};

struct BlankEnds {
  size_t first = 0, end = 0;        // the rows between, in which every column has a value where nothing is amiss
  size_t at_start = 0, at_end = 0;  // how many rows are before and behind them
  std::string names;                // of the columns without a value there: "velocity_1_m_s, acceleration_1_m_s2"
  size_t gap_row = 0;  // of a value that is missing between, of the column `gap`; gap is empty where none is
  std::string gap;
};

// All columns are of one length.
BlankEnds find_blank_ends(const std::vector<TableColumn>& columns);

// Keeps the rows from first to end.
template <typename Value>
void keep_rows(size_t first, size_t end, std::vector<Value>& values) {
  const auto at = [&](size_t row) { return values.begin() + static_cast<std::ptrdiff_t>(row); };
  values.erase(at(end), values.end());
  values.erase(values.begin(), at(first));
}

}  // namespace host_sim
