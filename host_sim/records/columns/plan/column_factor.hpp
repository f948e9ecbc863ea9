// From the values of a channel's column to SI.
#pragma once
#include <string>
#include <vector>

#include "host_sim/records/columns/column.hpp"
#include "host_sim/records/columns/column_meaning.hpp"
#include "host_sim/records/columns/plan/column_context.hpp"
#include "host_sim/records/columns/units/units.hpp"

namespace host_sim {

// What a column is taken for.
struct Reading {
  Dimension dimension;
  std::string unit;     // as the user or the file says; may be empty
  bool mapped = false;  // the column has a name of its own: then it is said that it has no unit
};

std::string said_factor(double factor);  // ": values times 0.001"

// Sets the factor of a use whose channel is known, and notes what is done. Refuses an unknown or foreign unit, and a voltage without
// its sensor's sensitivity.
void find_factor(const ColumnContext& context, const Column& column, const Reading& reading, ColumnUse& use,
                 std::vector<std::string>& notes);

}  // namespace host_sim
