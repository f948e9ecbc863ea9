// A diagnosis as text for a terminal: the short form of the report.
#pragma once
#include <string>

#include "host_sim/reports/data/report_data.hpp"

namespace host_sim {

// Sentences are wrapped at `width` columns; 0: not at all.
std::string diagnosis_text(const reports::DiagnosisReportData& data, bool colours, int width = 0);

}  // namespace host_sim
