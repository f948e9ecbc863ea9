#include "host_sim/records/csv/blanks/blank_ends.hpp"

#include <algorithm>
#include <cmath>

namespace host_sim {

BlankEnds find_blank_ends(const std::vector<TableColumn>& columns) {
  BlankEnds found;
  const auto there = [](double value) { return !std::isnan(value); };
  const size_t rows = columns.empty() ? 0 : columns.front().values->size();
  found.end = rows;
  for (const TableColumn& column : columns) {
    const std::vector<double>& v = *column.values;
    const auto first = static_cast<size_t>(std::find_if(v.begin(), v.end(), there) - v.begin());
    const auto end = static_cast<size_t>(v.rend() - std::find_if(v.rbegin(), v.rend(), there));
    found.first = std::max(found.first, first), found.end = std::min(found.end, end);
    if (first > 0 || end < rows) found.names += (found.names.empty() ? "" : ", ") + column.name;
  }
  found.end = std::max(found.first, found.end);
  found.at_start = found.first, found.at_end = rows - found.end;
  for (size_t row = found.first; row < found.end; ++row)
    for (const TableColumn& column : columns)
      if (!there((*column.values)[row])) {
        found.gap_row = row, found.gap = column.name;
        return found;
      }
  return found;
}

}  // namespace host_sim
