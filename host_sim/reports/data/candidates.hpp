// What the diagnosis tried, as the page lists it.
#pragma once
#include <vector>

#include "host_sim/diagnosis/diagnosis.hpp"
#include "host_sim/reports/data/report_data.hpp"

namespace host_sim::reports {

// Sensor faults (judged before any rig model) first, then the effects by what each alone would bring; at the end what
// was named or rejected without being among the best.
std::vector<Candidate> candidates(const diagnosis::Diagnosis& found);

}  // namespace host_sim::reports
