// One example as Markdown, and its pictures.
#pragma once
#include <string>

#include "host_sim/reports/data/report_data.hpp"
#include "tests/examples/examples.hpp"

namespace examples {

// The section of the page; its pictures are written as pictures/NAME_*.svg below `docs`.
std::string section(const Example& example, const host_sim::reports::DiagnosisReportData& data,
                    const std::string& docs);

}  // namespace examples
