// The tables of the diagnosis page, each a section; what is empty has none.
#pragma once
#include "host_sim/reports/data/report_data.hpp"
#include "host_sim/reports/page/page.hpp"

namespace host_sim::reports {

void add_gain(Page& page, const DiagnosisReportData& data);
void add_parameters(Page& page, const DiagnosisReportData& data);
void add_candidates(Page& page, const DiagnosisReportData& data);

}  // namespace host_sim::reports
