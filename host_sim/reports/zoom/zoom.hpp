// Time records that can be zoomed, one at a time, with their error below.
#pragma once
#include <string>
#include <vector>

#include "host_sim/reports/data/report_data.hpp"
#include "host_sim/reports/data/run_report_data.hpp"
#include "host_sim/reports/page/page.hpp"

namespace host_sim::reports {

// One channel: what was measured and what was simulated beside it.
struct ZoomCurve {
  std::string label;
  Role role;
  const std::vector<double>* values;
};
struct ZoomRecord {
  std::string title, quantity, unit;  // "DOF 1 displacement", "displacement", "m"
  double start_s = 0.0, period_s = 0.0;
  std::vector<ZoomCurve> curves;  // the first is the reference of the errors; all of one length
};

std::vector<ZoomRecord> zoom_records(const std::vector<DofView>& views);
std::vector<ZoomRecord> zoom_records(const RunRecord& record);

// A section with all records; none where the program was built without the script, or there is nothing to zoom. All
// points of all records together stay below a budget: longer records keep the smallest and largest value of every bin.
void add_zoom(Page& page, const std::vector<ZoomRecord>& records);

// For tests: signed 16-bit numbers, little endian, in base 64; low and high are -32767 and 32767.
std::string packed(const std::vector<double>& values, double low, double high);
// Two points a bin, the smallest and the largest value in the order in which they come; `values` as it is where it has
// no more than 2 * bins points.
std::vector<double> thinned(const std::vector<double>& values, size_t bins);

}  // namespace host_sim::reports
