// The smallest strengths that would have been seen, as tables: one page holds them, however many links a rig has.
#pragma once
#include <vector>

#include "host_sim/reports/data/report_data.hpp"
#include "host_sim/reports/page/page.hpp"

namespace host_sim::reports {

// Effects of links (a row each) by link, of DOFs by DOF, and channels (a row each) by fault; those that have entries. A cell
// holds the strength with its unit and, below, its force in percent of the damping force.
std::vector<HtmlTable> detectable_tables(const std::vector<Detectable>& limits);

}  // namespace host_sim::reports
