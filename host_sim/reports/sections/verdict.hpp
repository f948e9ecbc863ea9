// The verdict in words.
#pragma once
#include <string>

#include "host_sim/reports/data/report_data.hpp"

namespace host_sim::reports {

// "cubic_stiffness", "link 1-2" -> "cubic stiffness on link 1-2".
std::string cause_text(const std::string& effect, const std::string& where);

// Coefficients that no interval holds follow any motion: that nothing is missing is then no finding.
bool tells_nothing(const DiagnosisReportData& data);

// What the simulation lacks, or that it lacks nothing these data could show, in a dozen words without a full stop.
std::string verdict_headline(const DiagnosisReportData& data);
// What else has to be said, in whole sentences; empty: nothing.
std::string verdict_details(const DiagnosisReportData& data);
// Both.
std::string verdict_sentence(const DiagnosisReportData& data);

}  // namespace host_sim::reports
