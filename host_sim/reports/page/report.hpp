// The pages. Each is one file, DIR/index.html, that opens offline: styles, pictures and the script that zooms are inside.
// Beside it stands the data of every picture, DIR/figures/<number>_<title>.csv.
#pragma once
#include <string>

#include "host_sim/reports/data/report_data.hpp"
#include "host_sim/reports/data/run_report_data.hpp"

namespace host_sim::reports {

// Writes DIR/index.html (DIR is made where missing). Throws OutputError where that fails;
// an earlier index.html then stays as it was and nothing half-written is left.
void write_diagnosis_report(const std::string& directory, const DiagnosisReportData& data);
void write_estimate_report(const std::string& directory, const EstimateReportData& data);
void write_run_report(const std::string& directory, const RunReportData& data);

// Throws OutputError where no page can come there, before what is to stand in it is computed. "": none is wanted.
void require_place(const std::string& directory);

// The same pages as text, for tests.
std::string diagnosis_page(const DiagnosisReportData& data);
std::string estimate_page(const EstimateReportData& data);
std::string run_page(const RunReportData& data);

}  // namespace host_sim::reports
