// The estimates of a node as a table that fits a width.
#pragma once
#include <vector>

#include "host_sim/live/screen/text.hpp"
#include "host_sim/live/state/bus_picture.hpp"

namespace live {

struct TableView {
  int width = 80;
  bool unicode = true;
  int first_row = 0, most_rows = 1000;
};

// A head and a row for each estimate: parameter, value, half of the 95 % interval, unit, status, trend. The trend takes
// what is left and goes first where it is narrow; then long names are cut, then units.
std::vector<Line> estimate_table(const BusPicture& picture, int node, const TableView& view);

Role role_of_status(const std::string& status);

}  // namespace live
