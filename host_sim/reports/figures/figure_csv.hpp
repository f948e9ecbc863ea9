// A picture's data as a table that any program reads.
#pragma once
#include <string>

#include "host_sim/reports/figures/plot.hpp"

namespace host_sim::reports {

// CSV, one row a point, in the picture's base units: curve,<x_label>_<unit>,<y_label>_<unit>, for pictures with a band also
// upper (its other edge). Points that the picture leaves out (not finite) are left out. A colour map has the rows
// <x>,<y>,value of the middles of its cells that are known. Curves without a name in the legend are called curve_<n>.
std::string figure_csv(const Plot& plot);

// "07_dof_1_displacement.csv" for the seventh picture of a page: letters, digits and underscores of its title.
std::string figure_file_name(size_t number, const Plot& plot);
// Is it a name as figure_file_name() gives it?
bool is_figure_file_name(const std::string& name);

}  // namespace host_sim::reports
