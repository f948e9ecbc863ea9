// A column of a data file (a variable of a MAT file) as it is named there.
#pragma once
#include <string>
#include <vector>

#include "host_sim/records/columns/names/column_name.hpp"

namespace host_sim {

struct Column {
  std::string head;  // as it stands in the file, without quotes
  std::string unit;  // of a row of units; may be empty
};

// Its name and its unit; of a row of units before the head's own.
HeadParts parts_of(const Column& column);

// The head, quoted.
std::string quoted_head(const Column& column);
std::string quoted_heads(const std::vector<Column>& columns);  // with commas between; of many the first dozen

}  // namespace host_sim
