// The units that are known, each with what it measures and its factor to SI.
#pragma once
#include "host_sim/records/columns/units/units.hpp"

namespace host_sim {

struct UnitRow {
  const char* word;  // blanks, "*", "-" and "^" left out
  Dimension dimension;
  double to_si;
};

// The first spelling of a unit is its SI form or the usual one.
struct UnitRows {
  const UnitRow *first, *last;
  const UnitRow* begin() const { return first; }
  const UnitRow* end() const { return last; }
};
UnitRows unit_rows();

}  // namespace host_sim
