// What else has to be said beside a verdict; empty where there is nothing.
#pragma once
#include <string>
#include <vector>

#include "host_sim/reports/data/report_data.hpp"

namespace host_sim::reports {

// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& items, const char* last_word);

// Without which channels it is said.
std::string left_out_text(const DiagnosisReportData& data);
// From which second on.
std::string later_start_text(const DiagnosisReportData& data);
// Of what.
std::string along_motion_text(const DiagnosisReportData& data);
// Friction whose bristles bend acts in the place of the rig's own: its coefficient stands in the table under both names.
std::string one_friction_text(const DiagnosisReportData& data);

}  // namespace host_sim::reports
